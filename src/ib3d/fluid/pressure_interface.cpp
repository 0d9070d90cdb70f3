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

template <class T>
void PressureInterface::take_base(const CellField<T>& coarse)
{
  for (Piece& piece : pieces_) {
    if (piece.coarse_patch < 0) continue;
    const int d = side_direction(piece.side);
    const Array3<T>& a = coarse[piece.coarse_patch];
    const std::ptrdiff_t s1 = a.stride(d == 0 ? 1 : 0), s2 = a.stride(d == 2 ? 1 : 2);
    for_each_face(piece, [&](const Int3& c, std::size_t n) {
      const T* v = a.at(c[0] + piece.shift[0], c[1] + piece.shift[1], c[2] + piece.shift[2]);
      const auto at = [&](std::ptrdiff_t m) { return static_cast<double>(v[m]); };
      const double slope1 = 0.125 * (at(s1) - at(-s1)), slope2 = 0.125 * (at(s2) - at(-s2));
      const double twist = (1.0 / 64) * (at(s1 + s2) - at(s1 - s2) - at(s2 - s1) + at(-s1 - s2));
      const double middle = at(0) + (1.0 / 32) * (at(s1) + at(-s1) + at(s2) + at(-s2) - 4 * at(0));
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
