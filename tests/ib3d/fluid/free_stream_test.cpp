// What must stay as it is: a uniform stream, and fluid at rest under a force with a potential.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/max_or_nan.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {
namespace {

double largest_difference(const Level& level, const MacField& a, const MacField& b)
{
  double m = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(level, p, c, [&](int i, int j, int k) {
        m = max_or_nan(m, std::abs(a(p, c)(i, j, k) - b(p, c)(i, j, k)));
      });
  return m;
}

TEST(NavierStokes, UniformStreamStaysUniform)
{
  for (const int boxes : {1, 4}) {
    const Hierarchy grid(periodic_box({1, 1, 2}), 1.0 / 16, MPI_COMM_SELF, boxes);
    const Level& level = grid.finest();
    NavierStokes fluid(grid, {}, {}, {"multilevel", 1e-9, 50});
    MacField stream(level), none(level);
    fill_faces(level, stream, [](int c, const Vec3&) { return c == 0 ? 1.0 : c == 1 ? -0.7 : 0.3; });
    fluid.set_velocity({stream});
    for (int step = 0; step < 5; ++step) {
      fluid.begin_step(none, 0.01);
      fluid.solve_pressure({});
      fluid.finish_step({});
    }
    EXPECT_LT(largest_difference(level, fluid.u()[0], stream), 1e-13);
  }
}

TEST(NavierStokes, UniformStreamCrossesLevelsUnchanged)
{
  for (const int levels : {2, 3}) {
    const Hierarchy grid = nested_grid(periodic_box({1, 1, 2}), 1.0 / 16, levels, false, 3);
    NavierStokes fluid(grid, {}, {}, {"multilevel", 1e-9, 50});
    const auto uniform = [](int c, const Vec3&) { return c == 0 ? 1.0 : c == 1 ? -0.7 : 0.3; };
    CompositeMac stream = composite_faces(grid);
    for (std::size_t l = 0; l < stream.size(); ++l) fill_faces(grid.levels()[l], stream[l], uniform);
    fluid.set_velocity(stream);
    for (int step = 0; step < 5; ++step) {
      fluid.begin_step(composite_faces(grid), 0.005);
      fluid.solve_pressure({});
      fluid.finish_step({});
    }
    for (std::size_t l = 0; l < stream.size(); ++l)
      EXPECT_LT(largest_difference(grid.levels()[l], fluid.u()[l], stream[l]), 1e-11) << levels << " " << l;
  }
}

TEST(NavierStokes, ForceWithAPotentialMovesNothingInAClosedBox)
{
  const Hierarchy grid(walled_box({1, 1, 2}), 1.0 / 16, MPI_COMM_SELF, 2);
  const Level& level = grid.finest();
  NavierStokes fluid(grid, {}, {}, {"multilevel", 1e-9, 50});
  const auto potential = [](Vec3 x) { return 100 * std::sin(2 * x[0]) * std::cos(3 * x[1] - x[2]); };
  MacField f(level), rest(level);
  fill_faces(level, f, [&](int c, const Vec3& x) {
    Vec3 below = x, above = x;
    below[c] -= 0.5 * level.h;
    above[c] += 0.5 * level.h;
    return (potential(above) - potential(below)) / level.h;
  });
  for (int step = 0; step < 5; ++step) {
    fluid.begin_step(f, 0.01);
    fluid.solve_pressure({});
    fluid.finish_step({});
  }
  EXPECT_LT(largest_difference(level, fluid.u()[0], rest), 1e-8);
  // The pressure has taken up the force: p - potential is the same everywhere.
  double low = 1e300, high = -1e300;
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(level.local_box(p), [&](int i, int j, int k) {
      const double rest_of_p = fluid.p()[0][p](i, j, k) -
                               potential({(i + 0.5) * level.h, (j + 0.5) * level.h, (k + 0.5) * level.h});
      low = min_or_nan(low, rest_of_p);
      high = max_or_nan(high, rest_of_p);
    });
  EXPECT_LT(high - low, 1e-6);
}

}  // namespace
}  // namespace valsalva::ib3d
