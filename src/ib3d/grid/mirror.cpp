#include "ib3d/grid/mirror.hpp"

namespace valsalva::ib3d {

namespace {

/// Calls pair(ghost, inner, sign) with the addresses of every ghost beyond `side` and of the value it
/// mirrors.
template <class Pair>
void for_each_mirror_pair(const Level& level, const IndexBox& cells, int side, int component,
                          Array3<double>& a, int ghosts, Pair&& pair)
{
  const int d = side_direction(side);
  const auto dd = static_cast<std::size_t>(d);
  const bool normal = component == d;
  const double sign = normal ? 1.0 : -1.0;
  const int edge = side_is_high(side) ? level.box.hi[dd] : level.box.lo[dd];
  const IndexBox all = faces_of(cells.grown(ghosts), component);
  for (int m = 1; m <= ghosts; ++m) {
    int ghost = edge - m, inner = normal ? edge + m : edge + m - 1;
    if (side_is_high(side)) {
      ghost = normal ? edge + m : edge + m - 1;
      inner = edge - m;
    }
    IndexBox layer = all;
    layer.lo[dd] = ghost;
    layer.hi[dd] = ghost + 1;
    const std::ptrdiff_t jump = (inner - ghost) * a.stride(d);
    for_each_row(layer, [&](int j, int k) {
      double* row = a.at(layer.lo[0], j, k);
      for (int i = 0; i < layer.size(0); ++i) pair(row[i], row[i + jump], sign);
    });
  }
}

}  // namespace

void fill_mirrored(const Level& level, MacField& u)
{
  for (int p = 0; p < u.patch_count(); ++p)
    for (int side = 0; side < kSideCount; ++side)
      if (level.at_side(level.local_box(p), side))
        for (int c = 0; c < 3; ++c)
          for_each_mirror_pair(level, level.local_box(p), side, c, u(p, c), u.ghosts(),
                               [](double& ghost, const double& inner, double sign) { ghost = sign * inner; });
}

void fold_mirrored(const Level& level, MacField& f)
{
  for (int p = 0; p < f.patch_count(); ++p)
    for (int side = kSideCount - 1; side >= 0; --side)
      if (level.at_side(level.local_box(p), side))
        for (int c = 0; c < 3; ++c)
          for_each_mirror_pair(level, level.local_box(p), side, c, f(p, c), f.ghosts(),
                               [](double& ghost, double& inner, double sign) {
                                 inner += sign * ghost;
                                 ghost = 0;
                               });
}

}  // namespace valsalva::ib3d
