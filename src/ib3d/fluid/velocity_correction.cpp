#include "ib3d/fluid/velocity_correction.hpp"

#include <algorithm>

#include "ib3d/fluid/courant_rate.hpp"
#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

/// The faces of local patch `patch` with index k along z; they read p at k and k - 1.
void correct_plane(const Level& level, int patch, int k, double factor, const Array3<double>& p, MacField& u)
{
  for (int d = 0; d < 3; ++d) {
    IndexBox faces = faces_of(level.local_box(patch), d);
    if (k >= faces.hi[2]) continue;
    faces.lo[2] = k;
    faces.hi[2] = k + 1;
    for_each_row(faces, [&](int j, int) {
      correct_row(u(patch, d).at(faces.lo[0], j, k), p.at(faces.lo[0], j, k), factor, p.stride(d),
                  faces.size(0));
    });
  }
}

}  // namespace

void subtract_gradient(const Level& level, double time_over_density, const CellField<double>& p, MacField& u)
{
  for (int patch = 0; patch < level.local_count(); ++patch) {
    const IndexBox& cells = level.local_box(patch);
    for (int k = cells.lo[2]; k <= cells.hi[2]; ++k)
      correct_plane(level, patch, k, time_over_density / level.h, p[patch], u);
  }
}

double correct_velocity(const Hierarchy& grid, const OpeningModes& modes, const std::vector<double>& phi,
                        double time_over_density, CompositeCells<double>& p, CompositeMac& u)
{
  double rate = 0;
  for (int l = 0; l < grid.level_count(); ++l) {
    const Level& level = grid.level(l);
    const bool finest = l + 1 == grid.level_count();
    const auto ll = static_cast<std::size_t>(l);
    for (int patch = 0; patch < level.local_count(); ++patch) {
      const IndexBox& cells = level.local_box(patch);
      for (int k = cells.lo[2] - 1; k <= cells.hi[2]; ++k) {
        modes.add_to_plane(phi, l, patch, k, p[ll][patch]);
        if (k < cells.lo[2]) continue;
        correct_plane(level, patch, k, time_over_density / level.h, p[ll][patch], u[ll]);
        if (finest && k > cells.lo[2]) rate = std::max(rate, courant_rate(level, u[ll], patch, k - 1));
      }
    }
  }
  return rate;
}

}  // namespace valsalva::ib3d
