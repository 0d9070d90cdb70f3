// Kinetic energy of known flows on one and on two levels.
#include "ib3d/fluid/kinetic_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ib3d/fluid/grids.hpp"

namespace valsalva::ib3d {
namespace {

/// u = (a sin(2 pi y), 0, b) on all faces of all levels, ghosts included.
CompositeMac shear_and_stream(const Hierarchy& grid, double a, double b)
{
  CompositeMac u;
  for (const Level& level : grid.levels()) {
    u.emplace_back(level);
    for (int p = 0; p < level.local_count(); ++p)
      for_each_index(u.back()(p, 0).stored(), [&](int i, int j, int k) {
        u.back()(p, 0)(i, j, k) = a * std::sin(2 * M_PI * (j + 0.5) * level.h);
        u.back()(p, 2)(i, j, k) = b;
      });
  }
  return u;
}

TEST(KineticEnergy, CountsEveryPartOfTheDomainOnceOnAllLevels)
{
  // rho/2 (a^2/2 + b^2) V with rho = 1.06, a = 3, b = 2, V = 1: the sums over whole periods of sin^2 are exact.
  for (int levels : {1, 2}) {
    const Hierarchy grid = nested_grid(periodic_box({1, 1, 1}), 1.0 / 16, levels);
    EXPECT_NEAR(kinetic_energy(grid, shear_and_stream(grid, 3, 2), 1.06), 0.53 * (4.5 + 4), 1e-12) << levels;
  }
}

}  // namespace
}  // namespace valsalva::ib3d
