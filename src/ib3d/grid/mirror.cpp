#include "ib3d/grid/mirror.hpp"

namespace valsalva::ib3d {

namespace {

/// Where layer m beyond a side lies and where its image does, counted from the boundary face for the normal component,
/// else from the first cell above it.
struct Reflection {
  int edge;
  bool normal, high;
  Reflection(const Level& level, Side side, int component)
      : edge(level.box.faces_at(side)), normal(component == axis(side)), high(is_high(side))
  {
  }
  double sign() const { return normal ? 1.0 : -1.0; }
  int ghost(int m) const { return high ? (normal ? m : m - 1) : -m; }
  int inner(int m) const { return high ? -m : (normal ? m : m - 1); }
};

/// Beyond the sides along x, all layers of a row together and the end of one row with the start of the next, so that
/// memory is walked once.
void mirror_rows(const Level& level, const IndexBox& cells, int component, Array3<double>& a, int ghosts)
{
  constexpr int kAhead = 8;  // rows; the hardware does not foresee these strides
  const IndexBox rows = faces_of(cells.grown(ghosts), component);
  for (int k = rows.lo[2]; k < rows.hi[2]; ++k)
    for (const Side side : {Side::x_lo, Side::x_hi}) {
      if (!level.at_side(cells, side)) continue;
      const Reflection at(level, side, component);
      for (int j = rows.lo[1]; j < rows.hi[1]; ++j) {
        double* row = a.at(at.edge, j, k);
        __builtin_prefetch(row + kAhead * a.stride(1) - ghosts, 1);
        __builtin_prefetch(row + kAhead * a.stride(1) + ghosts - 1, 1);
        for (int m = 1; m <= ghosts; ++m) row[at.ghost(m)] = at.sign() * row[at.inner(m)];
      }
    }
}

/// Beyond a side along y or z.
void mirror_layers(const Level& level, const IndexBox& cells, Side side, int component, Array3<double>& a,
                   int ghosts)
{
  const Reflection at(level, side, component);
  IndexBox layer = faces_of(cells.grown(ghosts), component);
  const int n = layer.size(0);
  for (int m = 1; m <= ghosts; ++m) {
    layer = layer.with_range(axis(side), at.edge + at.ghost(m), 1);
    const std::ptrdiff_t jump = (at.inner(m) - at.ghost(m)) * a.stride(axis(side));
    for_each_row(layer, [&](int j, int k) {
      double* row = a.at(layer.lo[0], j, k);
      for (int i = 0; i < n; ++i) row[i] = at.sign() * row[i + jump];
    });
  }
}

}  // namespace

void fill_mirrored(const Level& level, MacField& u, int layers)
{
  for (int p = 0; p < u.patch_count(); ++p) {
    const IndexBox& cells = level.local_box(p);
    for (int c = 0; c < 3; ++c) {
      mirror_rows(level, cells, c, u(p, c), layers);
      for (const Side side : {Side::y_lo, Side::y_hi, Side::z_lo, Side::z_hi})
        if (level.at_side(cells, side)) mirror_layers(level, cells, side, c, u(p, c), layers);
    }
  }
}

}  // namespace valsalva::ib3d
