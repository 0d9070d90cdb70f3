#include "ib3d/fluid/pressure_interface.hpp"

#include <algorithm>

namespace valsalva::ib3d {

PressureInterface::PressureInterface(const Level& coarse, const Level& fine) : coarse_(coarse), fine_(fine)
{
  MPI_Comm_rank(coarse.comm, &rank_);
  const std::vector<int> here = coarse_.local_numbers(), there = fine_.local_numbers();
  for (std::size_t f = 0; f < fine_.patches.size(); ++f)
    for (int side = 0; side < kSideCount; ++side) {
      const IndexBox& box = fine_.patches[f].box;
      if (fine_.at_side(box, side)) continue;
      const auto d = static_cast<std::size_t>(side_direction(side));
      IndexBox outside = box;
      outside.lo[d] = side_is_high(side) ? box.hi[d] : box.lo[d] - 2;
      outside.hi[d] = outside.lo[d] + 2;  // one coarse cell
      std::vector<IndexBox> edge{outside};
      for_each_image(fine_, [&](const Int3& shift) {
        for (const Patch& p : fine_.patches) edge = without(edge, p.box.shifted(shift));
      });
      for (const IndexBox& part : edge)
        for (std::size_t c = 0; c < coarse_.patches.size(); ++c)
          for_each_image(coarse_, [&](const Int3& shift) {
            const Int3 back{-shift[0], -shift[1], -shift[2]};
            const IndexBox cells = intersect(part.coarsened(), coarse_.patches[c].box.shifted(back));
            const int fine_owner = fine_.patches[f].owner, coarse_owner = coarse_.patches[c].owner;
            if (cells.empty() || (fine_owner != rank_ && coarse_owner != rank_)) return;
            pieces_.push_back({side, there[f], here[c], fine_owner, coarse_owner, cells, shift,
                               std::vector<double>(static_cast<std::size_t>(4 * cells.volume()), 0.0)});
          });
    }
}

void PressureInterface::zero_base()
{
  for (Piece& piece : pieces_) std::fill(piece.values.begin(), piece.values.end(), 0.0);
}

void PressureInterface::send(bool to_fine)
{
  std::vector<MPI_Request> requests;
  for (Piece& piece : pieces_) {
    if (piece.fine_owner == piece.coarse_owner) continue;
    const int other = piece.fine_owner == rank_ ? piece.coarse_owner : piece.fine_owner;
    const bool receiving = (piece.fine_owner == rank_) == to_fine;
    const auto count = static_cast<int>(piece.values.size());
    if (receiving)
      MPI_Irecv(piece.values.data(), count, MPI_DOUBLE, other, 4, coarse_.comm, &requests.emplace_back());
    else
      MPI_Isend(piece.values.data(), count, MPI_DOUBLE, other, 4, coarse_.comm, &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

namespace {

/// Coarse values around a cell in the plane of an interface, (m, n) in -1..1 along the two tangents. Beyond the sides
/// of the domain they are extrapolated quadratically: what a wall does to the pressure there is not the fine grid's
/// business.
template <class T>
struct Plane {
  const T* cell;
  std::ptrdiff_t s1, s2;
  int side1, side2;  ///< -1, +1: the cell lies at the low, high side of the domain along the tangent, else 0

  double raw(int m, int n) const { return static_cast<double>(cell[m * s1 + n * s2]); }
  double along1(int m, int n) const
  {
    return m != 0 && m == side1 ? 3 * (raw(0, n) - raw(-m, n)) + raw(-2 * m, n) : raw(m, n);
  }
  double operator()(int m, int n) const
  {
    return n != 0 && n == side2 ? 3 * (along1(m, 0) - along1(m, -n)) + along1(m, -2 * n) : along1(m, n);
  }
};

int side_of(const Level& level, int d, int i)
{
  const auto dd = static_cast<std::size_t>(d);
  if (level.domain.periodic(d)) return 0;
  return i == level.box.lo[dd] ? -1 : i == level.box.hi[dd] - 1 ? 1 : 0;
}

}  // namespace

template <class T>
void PressureInterface::take_base(const CellField<T>& coarse)
{
  for (Piece& piece : pieces_) {
    if (piece.coarse_patch < 0) continue;
    const int d = side_direction(piece.side), t1 = d == 0 ? 1 : 0, t2 = d == 2 ? 1 : 2;
    const Array3<T>& a = coarse[piece.coarse_patch];
    for_each_face(piece, [&](const Int3& c, std::size_t n) {
      const Int3 at{c[0] + piece.shift[0], c[1] + piece.shift[1], c[2] + piece.shift[2]};
      const Plane<T> v{a.at(at[0], at[1], at[2]), a.stride(t1), a.stride(t2),
                       side_of(coarse_, t1, at[static_cast<std::size_t>(t1)]),
                       side_of(coarse_, t2, at[static_cast<std::size_t>(t2)])};
      const double slope1 = 0.125 * (v(1, 0) - v(-1, 0)), slope2 = 0.125 * (v(0, 1) - v(0, -1));
      const double twist = (1.0 / 64) * (v(1, 1) - v(1, -1) - v(-1, 1) + v(-1, -1));
      const double middle = v(0, 0) + (1.0 / 32) * (v(1, 0) + v(-1, 0) + v(0, 1) + v(0, -1) - 4 * v(0, 0));
      for (std::size_t m = 0; m < 4; ++m) {
        const double h1 = (m & 1) != 0 ? 1 : -1, h2 = (m & 2) != 0 ? 1 : -1;
        piece.values[n + m] = (8.0 / 15) * (middle + h1 * slope1 + h2 * slope2 + h1 * h2 * twist);
      }
    });
  }
  send(true);
}
template void PressureInterface::take_base(const CellField<double>&);
template void PressureInterface::take_base(const CellField<float>&);

template <class T>
void PressureInterface::fill_ghosts(CellField<T>& fine) const
{
  for (const Piece& piece : pieces_) {
    if (piece.fine_patch < 0) continue;
    const int d = side_direction(piece.side);
    Array3<T>& a = fine[piece.fine_patch];
    const bool high = side_is_high(piece.side);
    const std::ptrdiff_t inward = (high ? -1 : 1) * a.stride(d);
    const std::ptrdiff_t s1 = a.stride(d == 0 ? 1 : 0), s2 = a.stride(d == 2 ? 1 : 2);
    const std::ptrdiff_t places[4] = {0, s1, s2, s1 + s2};
    for_each_face(piece, [&](Int3 c, std::size_t n) {
      for (int& i : c) i *= 2;
      if (!high) ++c[static_cast<std::size_t>(d)];
      T* g = a.at(c[0], c[1], c[2]);
      for (std::size_t m = 0; m < 4; ++m) {
        T* ghost = g + places[m];
        *ghost = static_cast<T>(piece.values[n + m]) + static_cast<T>(2.0 / 3) * ghost[inward] -
                 static_cast<T>(0.2) * ghost[2 * inward];
      }
    });
  }
}
template void PressureInterface::fill_ghosts(CellField<double>&) const;
template void PressureInterface::fill_ghosts(CellField<float>&) const;

}  // namespace valsalva::ib3d
