// The pressure across the edge of a refined level: second order in p and in its gradient.
//   fine ghost     g = 8/15 c* + 2/3 p1 - 1/5 p2        p1 the fine cell at the edge, p2 the next one inward
//   c*             coarse value at the height of the fine cell, s_a = +-1 its half along tangent a:
//                  c0 + sum_a [ s_a/8 (c_{+a} - c_{-a}) + 1/32 (c_{+a} - 2 c0 + c_{-a}) ]
//                     + s1 s2/64 (c_{++} - c_{+-} - c_{-+} + c_{--})
//   coarse flux    the gradient on a coarse face at the edge is the mean over its four fine faces
// (docs/scheme.md, section 3; interpolation after Minion 1996 and Martin & Colella 2000.)
#pragma once

#include "ib3d/grid/copy_plan.hpp"

namespace valsalva::ib3d {

class PressureInterface {
 public:
  /// Between a level, which must outlive the object, and the next finer one.
  PressureInterface(const Level& coarse, const Level& fine);

  /// Takes 8/15 c* from coarse values with filled ghosts (their corners too). Collective.
  template <class T>
  void take_base(const CellField<T>& coarse);
  /// Sets the base to 0, for corrections that are 0 on the coarse level.
  void zero_base();
  /// Fills the ghosts of the fine level at its edge from the base and the fine values.
  template <class T>
  void fill_ghosts(CellField<T>& fine) const;

  /// Calls f(coarse patch, cell, side, sum) for each coarse cell outside the edge: `side` is that of the fine patch, so
  /// that the covered neighbour lies against its direction, and `sum` the sum of (ghost - p1) over the four fine faces between. Collective.
  template <class T, class F>
  void for_each_flux(const CellField<T>& fine, F&& f);

  /// Calls f(i, j, k) for the fine cells along the edge of local patch p, once per edge face.
  template <class F>
  void for_each_edge_cell(int p, F&& f) const;

 private:
  /// Coarse cells in a plane outside one face of a fine patch. `values` are 4 per cell; for a row of n cells along t1,
  /// the 2n along its lower half of fine cells in t2, then the 2n along the upper half.
  struct Piece {
    Side side;                     ///< of the fine patch
    int fine_patch, coarse_patch;  ///< local numbers, -1 on another rank
    int fine_owner, coarse_owner;
    IndexBox cells;  ///< in the fine patch's image
    Int3 shift;      ///< to the coarse patch's own cells
    std::vector<double> values;
  };
  template <class F>
  static void for_each_row(const Piece& piece, F&& f);
  /// From a ghost to the fine cell at the edge.
  template <class T>
  static std::ptrdiff_t inward_of(const Piece& piece, const Array3<T>& fine)
  {
    return inward(piece.side) * fine.stride(axis(piece.side));
  }
  /// The ghost at the low end of coarse cell c in both tangents.
  template <class A>
  static auto first_ghost(const Piece& piece, A& fine, Int3 c)
  {
    for (int& i : c) i *= 2;
    if (!is_high(piece.side)) ++c[static_cast<std::size_t>(axis(piece.side))];
    return fine.at(c[0], c[1], c[2]);
  }
  /// Moves the values of pieces that two ranks share.
  void send(bool to_fine);

  const Level& coarse_;
  int rank_ = 0;
  std::vector<Piece> pieces_;
};

template <class F>
void PressureInterface::for_each_edge_cell(int p, F&& f) const
{
  for (const Piece& piece : pieces_) {
    if (piece.fine_patch != p) continue;
    const IndexBox outside = piece.cells.refined();
    const auto d = static_cast<std::size_t>(axis(piece.side));
    const int at = is_high(piece.side) ? outside.lo[d] - 1 : outside.hi[d];
    for_each_index(outside.with_range(axis(piece.side), at, 1), f);
  }
}

/// Calls f(first coarse cell, number of cells, number of their first value) for the rows along t1.
template <class F>
void PressureInterface::for_each_row(const Piece& piece, F&& f)
{
  const auto t1 = static_cast<std::size_t>(first_tangent(piece.side)),
             t2 = static_cast<std::size_t>(second_tangent(piece.side));
  Int3 cell = piece.cells.lo;
  std::size_t value = 0;
  for (; cell[t2] < piece.cells.hi[t2]; ++cell[t2]) {
    const int n = piece.cells.size(static_cast<int>(t1));
    f(cell, n, value);
    value += 4 * static_cast<std::size_t>(n);
  }
}

template <class T, class F>
void PressureInterface::for_each_flux(const CellField<T>& fine, F&& f)
{
  for (Piece& piece : pieces_) {
    if (piece.fine_patch < 0) continue;
    const Array3<T>& a = fine[piece.fine_patch];
    const std::ptrdiff_t inward = inward_of(piece, a), s1 = a.stride(first_tangent(piece.side)),
                         s2 = a.stride(second_tangent(piece.side));
    for_each_row(piece, [&](const Int3& c, int count, std::size_t value) {
      const T* g = first_ghost(piece, a, c);
      for (int m = 0; m < count; ++m, g += 2 * s1) {
        const auto jump = [&](std::ptrdiff_t at) {
          return static_cast<double>(g[at]) - static_cast<double>(g[at + inward]);
        };
        piece.values[value + static_cast<std::size_t>(m)] = (jump(0) + jump(s1)) + (jump(s2) + jump(s1 + s2));
      }
    });
  }
  send(false);
  for (const Piece& piece : pieces_) {
    if (piece.coarse_patch < 0) continue;
    for_each_row(piece, [&](const Int3& c, int count, std::size_t value) {
      Int3 cell{c[0] + piece.shift[0], c[1] + piece.shift[1], c[2] + piece.shift[2]};
      for (int m = 0; m < count; ++m, ++cell[static_cast<std::size_t>(first_tangent(piece.side))])
        f(piece.coarse_patch, cell, piece.side, piece.values[value + static_cast<std::size_t>(m)]);
    });
  }
}

}  // namespace valsalva::ib3d
