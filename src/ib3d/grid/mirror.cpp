#include "ib3d/grid/mirror.hpp"

namespace valsalva::ib3d {

namespace {

/// Along x the layers of a row are filled together, so that memory is walked once.
void mirror_component(const Level& level, const IndexBox& cells, int side, int component, Array3<double>& a,
                      int ghosts)
{
  const int d = side_direction(side);
  const auto dd = static_cast<std::size_t>(d);
  const bool normal = component == d, high = side_is_high(side);
  const double sign = normal ? 1.0 : -1.0;
  const int edge = high ? level.box.hi[dd] : level.box.lo[dd];
  // Layer m and its image, counted from the boundary face (normal component) or the first cell above it.
  const auto ghost = [&](int m) { return high ? (normal ? m : m - 1) : -m; };
  const auto inner = [&](int m) { return high ? -m : (normal ? m : m - 1); };
  IndexBox layer = faces_of(cells.grown(ghosts), component);
  if (d == 0) {
    for_each_row(layer, [&](int j, int k) {
      double* row = a.at(edge, j, k);
      for (int m = 1; m <= ghosts; ++m) row[ghost(m)] = sign * row[inner(m)];
    });
    return;
  }
  for (int m = 1; m <= ghosts; ++m) {
    layer.lo[dd] = edge + ghost(m);
    layer.hi[dd] = layer.lo[dd] + 1;
    const std::ptrdiff_t jump = (inner(m) - ghost(m)) * a.stride(d);
    const int n = layer.size(0);
    for_each_row(layer, [&](int j, int k) {
      double* row = a.at(layer.lo[0], j, k);
      for (int i = 0; i < n; ++i) row[i] = sign * row[i + jump];
    });
  }
}

}  // namespace

void fill_mirrored(const Level& level, MacField& u)
{
  for (int p = 0; p < u.patch_count(); ++p)
    for (int side = 0; side < kSideCount; ++side)
      if (level.at_side(level.local_box(p), side))
        for (int c = 0; c < 3; ++c) mirror_component(level, level.local_box(p), side, c, u(p, c), u.ghosts());
}

}  // namespace valsalva::ib3d
