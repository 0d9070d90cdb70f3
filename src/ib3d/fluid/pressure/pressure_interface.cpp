#include "ib3d/fluid/pressure/pressure_interface.hpp"

#include <algorithm>

namespace valsalva::ib3d {

PressureInterface::PressureInterface(const Level& coarse, const Level& fine) : coarse_(coarse)
{
  MPI_Comm_rank(coarse.comm, &rank_);
  for (const Patch& patch : fine.patches)
    for (const Side side : kSides) {
      if (fine.at_side(patch.box, side)) continue;
      const int first = is_high(side) ? patch.box.faces_at(side) : patch.box.faces_at(side) - 2;
      const IndexBox outside = patch.box.with_range(axis(side), first, 2);  // one coarse cell
      for (const IndexBox& part : uncovered({outside}, fine))
        for_each_patch_image(coarse, [&](std::size_t c, const Int3& shift) {
          const Patch& under = coarse.patches[c];
          const IndexBox cells = intersect(part.coarsened(), under.box.shifted_back(shift));
          if (cells.empty() || (patch.owner != rank_ && under.owner != rank_)) return;
          pieces_.push_back({side, patch.local, under.local, patch.owner, under.owner, cells, shift,
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
  Messages messages(coarse_.comm, Tag::level_edges);
  for (Piece& piece : pieces_) {
    if (piece.fine_owner == piece.coarse_owner) continue;
    const int other = piece.fine_owner == rank_ ? piece.coarse_owner : piece.fine_owner;
    if ((piece.fine_owner == rank_) == to_fine)
      messages.receive(other, piece.values.data(), piece.values.size());
    else
      messages.send(other, piece.values.data(), piece.values.size());
  }
  messages.wait();
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

/// 8/15 c* of four fine cells: at low[0], low[1] in the lower half along the second tangent, high[0], high[1] in the upper.
/// v(m, n): the coarse values around.
template <class Values>
inline void base_of_cell(Values&& v, double* low, double* high)
{
  const double slope1 = 0.125 * (v(1, 0) - v(-1, 0)), slope2 = 0.125 * (v(0, 1) - v(0, -1));
  const double twist = (1.0 / 64) * (v(1, 1) - v(1, -1) - v(-1, 1) + v(-1, -1));
  const double middle = v(0, 0) + (1.0 / 32) * (v(1, 0) + v(-1, 0) + v(0, 1) + v(0, -1) - 4 * v(0, 0));
  low[0] = (8.0 / 15) * (middle - slope1 - slope2 + twist);
  low[1] = (8.0 / 15) * (middle + slope1 - slope2 - twist);
  high[0] = (8.0 / 15) * (middle - slope1 + slope2 - twist);
  high[1] = (8.0 / 15) * (middle + slope1 + slope2 + twist);
}

/// Ghosts of one row of fine cells, s apart.
template <class T>
inline void fill_ghost_row(T* ghost, const double* __restrict base, std::ptrdiff_t s, std::ptrdiff_t inward,
                           int n)
{
  for (int i = 0; i < n; ++i, ghost += s)
    *ghost = static_cast<T>(base[i]) + static_cast<T>(2.0 / 3) * ghost[inward] -
             static_cast<T>(0.2) * ghost[2 * inward];
}

}  // namespace

template <class T>
void PressureInterface::take_base(const CellField<T>& coarse)
{
  for (Piece& piece : pieces_) {
    if (piece.coarse_patch < 0) continue;
    const int t1 = first_tangent(piece.side), t2 = second_tangent(piece.side);
    const Array3<T>& a = coarse[piece.coarse_patch];
    const std::ptrdiff_t s1 = a.stride(t1), s2 = a.stride(t2);
    for_each_row(piece, [&](const Int3& c, int n, std::size_t value) {
      const Int3 at{c[0] + piece.shift[0], c[1] + piece.shift[1], c[2] + piece.shift[2]};
      const T* row = a.at(at[0], at[1], at[2]);
      double* low = &piece.values[value];
      double* high = low + 2 * n;
      const int side2 = side_of(coarse_, t2, at[static_cast<std::size_t>(t2)]);
      for (int m = 0; m < n; ++m) {
        const T* cell = row + m * s1;
        const int side1 =
            m == 0 || m == n - 1 ? side_of(coarse_, t1, at[static_cast<std::size_t>(t1)] + m) : 0;
        if (side1 != 0 || side2 != 0)
          base_of_cell(Plane<T>{cell, s1, s2, side1, side2}, low + 2 * m, high + 2 * m);
        else
          base_of_cell([&](int x, int y) { return static_cast<double>(cell[x * s1 + y * s2]); }, low + 2 * m,
                       high + 2 * m);
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
    Array3<T>& a = fine[piece.fine_patch];
    const std::ptrdiff_t inward = inward_of(piece, a), s1 = a.stride(first_tangent(piece.side)),
                         s2 = a.stride(second_tangent(piece.side));
    for_each_row(piece, [&](const Int3& c, int n, std::size_t value) {
      T* ghost = first_ghost(piece, a, c);
      const double* base = &piece.values[value];
      if (s1 == 1) {
        fill_ghost_row(ghost, base, 1, inward, 2 * n);
        fill_ghost_row(ghost + s2, base + 2 * n, 1, inward, 2 * n);
      } else {
        fill_ghost_row(ghost, base, s1, inward, 2 * n);
        fill_ghost_row(ghost + s2, base + 2 * n, s1, inward, 2 * n);
      }
    });
  }
}
template void PressureInterface::fill_ghosts(CellField<double>&) const;
template void PressureInterface::fill_ghosts(CellField<float>&) const;

}  // namespace valsalva::ib3d
