// Grids that tests of the fluid solver run on: one level, or refined boxes inside it.
#pragma once

#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {

/// Spacing h on level 0 of a walled or periodic domain; `levels` levels, each refined over the middle half of the one
/// below along x and y and over all of z but its ends, or over all of z.
inline Hierarchy nested_grid(const Domain& domain, double h, int levels, bool whole_length = false,
                             int boxes = 0)
{
  Refinement refinement;
  IndexBox box{{0, 0, 0}, {}};
  for (std::size_t d = 0; d < 3; ++d)
    box.hi[d] = static_cast<int>(std::lround(domain.size[static_cast<int>(d)] / h));
  for (int l = 1; l < levels; ++l) {
    for (std::size_t d = 0; d < 3; ++d) {
      if (d == 2 && whole_length) continue;
      const int quarter =
          std::max(4, box.size(static_cast<int>(d)) / 4 / 4 * 4);  // whole blocks of the finer level
      box.lo[d] += quarter;
      box.hi[d] -= quarter;
    }
    box = box.refined();
    refinement.push_back({box});
  }
  return Hierarchy(domain, h / (1 << (levels - 1)), MPI_COMM_WORLD, refinement, {}, boxes);
}

/// Calls f(level, patch, i, j, k) for every cell of this rank that no finer level covers.
template <class F>
void for_each_valid_cell(const Hierarchy& grid, F&& f)
{
  for (int l = 0; l < grid.level_count(); ++l)
    for (int p = 0; p < grid.level(l).local_count(); ++p)
      for_each_index(grid.level(l).local_box(p), [&](int i, int j, int k) {
        if (!grid.covered(l, {i, j, k})) f(static_cast<std::size_t>(l), p, i, j, k);
      });
}

}  // namespace valsalva::ib3d
