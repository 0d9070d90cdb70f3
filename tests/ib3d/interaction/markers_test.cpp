// Passive markers: they follow an exact flow to second order in dt, over boxes and levels; they set out when they are
// due, and are counted when they leave.
#include "ib3d/interaction/markers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/max_or_nan.hpp"
#include "ib3d/interaction/rotating_flow.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kEnd = 1.5;

double largest_error(const Hierarchy& grid, int steps)
{
  const std::vector<Vec3> start = points_about_the_axis();
  Markers markers({{"all", start}});
  turn(markers, grid, steps, kEnd);
  EXPECT_EQ(markers.local().size(), start.size());
  double error = 0;
  for (const Marker& m : markers.local())
    error = max_or_nan(error, norm(m.X - turned(start[static_cast<std::size_t>(m.id)], kEnd)));
  return error;
}

TEST(Markers, FollowATurningFlowToSecondOrderInDtOverBoxesAndLevels)
{
  for (const int levels : {1, 2}) {
    const Hierarchy grid = nested_grid(walled_box(kTurningBox), 0.125, levels, false, 8);
    const double coarse = largest_error(grid, 100), fine = largest_error(grid, 200);
    const double order = std::log2(coarse / fine);
    RecordProperty("order_levels_" + std::to_string(levels), std::to_string(order));
    EXPECT_GT(order, 1.9);
    EXPECT_LT(order, 2.3);
    EXPECT_LT(fine, 3e-3);
  }
}

TEST(Markers, LieInTheFinestBoxThatHoldsThem)
{
  const Hierarchy grid = nested_grid(walled_box(kTurningBox), 0.125, 2, false, 8);
  Markers markers({{"all", points_about_the_axis()}});
  int on_level[2] = {0, 0};
  for (int round = 0; round < 5; ++round) {
    turn(markers, grid, 10, 0.1);
    for (const Marker& m : markers.local()) {
      Int3 cell{};
      const Level& level = grid.level(m.level);
      for (int d = 0; d < 3; ++d) cell[static_cast<std::size_t>(d)] = static_cast<int>(m.X[d] / level.h);
      EXPECT_TRUE(level.local_box(m.patch).contains(cell));
      EXPECT_FALSE(grid.covered(m.level, cell));
      ++on_level[m.level];
    }
  }
  EXPECT_GT(on_level[0], 0);
  EXPECT_GT(on_level[1], 0);
}

TEST(Markers, ThoseThatLeaveTheDomainAreGivenUpAndCounted)
{
  const Vec3 size{1, 1, 2};
  for (const bool periodic : {false, true}) {
    const Hierarchy grid(periodic ? periodic_box(size) : walled_box(size), 0.125, MPI_COMM_WORLD);
    CompositeMac u = composite_faces(grid);  // 1 cm/s along z
    for (int p = 0; p < u[0].patch_count(); ++p)
      std::fill(u[0](p, 2).data().begin(), u[0](p, 2).data().end(), 1.0);
    Markers markers({{"all", {{0.5, 0.5, 0.3}, {0.5, 0.5, 0.95}, {0.2, 0.5, 1.5}, {0.5, 0.01, 1.97}}}});
    markers.seed_due(grid, u, 0);
    for (int step = 0; step < 100; ++step) markers.advance(grid, u, 0.01);
    EXPECT_EQ(markers.lost(), periodic ? 0 : 2);
    ASSERT_EQ(markers.local().size(), periodic ? 4U : 2U);
    const std::vector<Marker> all = markers.gather(MPI_COMM_WORLD);
    EXPECT_NEAR(all[0].X[2], 1.3, 1e-12);
    EXPECT_NEAR(all[1].X[2], 1.95, 1e-12);
    if (periodic) {
      EXPECT_NEAR(all[2].X[2], 0.5, 1e-12);
    }
  }
}

TEST(Markers, SetOutAtTheFirstStepsAtOrAfterTheirTimes)
{
  const Hierarchy grid(walled_box({1, 1, 2}), 0.125, MPI_COMM_WORLD);
  Markers markers({{"once", {{0.5, 0.5, 0.5}}, 0.05},
                   {"often", {{0.5, 0.5, 1}, {0.5, 0.5, 1.5}}, 0.1, 0.1, 0.31},
                   {"every step", {{0.2, 0.2, 0.2}}, 0.3, 0.01}});
  for (int step = 0; step <= 14; ++step) markers.seed_due(grid, composite_faces(grid), 0.03 * step);
  std::vector<double> times[3];
  for (const Marker& m : markers.gather(MPI_COMM_WORLD)) times[m.group].push_back(m.seeded_s);
  ASSERT_EQ(times[0].size(), 1U);
  EXPECT_NEAR(times[0][0], 0.06, 1e-12);
  ASSERT_EQ(times[1].size(), 6U);
  EXPECT_NEAR(times[1][0], 0.12, 1e-12);
  EXPECT_NEAR(times[1][2], 0.21, 1e-12);
  EXPECT_NEAR(times[1][5], 0.30, 1e-12);
  EXPECT_EQ(times[2].size(), 5U);  // 0.30, 0.33, ..., 0.42: no pile of those that were passed over
}

}  // namespace
}  // namespace valsalva::ib3d
