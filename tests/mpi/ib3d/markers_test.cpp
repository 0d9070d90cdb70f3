// Markers on several ranks: where they go does not depend on the ranks, and a checkpoint brings all of them back.
#include "ib3d/interaction/markers.hpp"

#include <gtest/gtest.h>

#include "ib3d/interaction/rotating_flow.hpp"
#include "ib3d/output/mpi_session.hpp"

namespace valsalva::ib3d {
namespace {

Hierarchy grid_on(MPI_Comm comm)
{
  const Domain domain = walled_box(kTurningBox);
  return Hierarchy(domain, 0.125 / 2, comm, {{IndexBox{{8, 8, 16}, {24, 24, 48}}}}, {}, 8);
}

/// Two groups, some of the second leave through the end of the box.
Markers two_groups()
{
  std::vector<Vec3> points = points_about_the_axis(), high;
  for (const Vec3& X : points) high.push_back({X[0], X[1], 3.2 + 0.2 * X[2]});
  return Markers({{"low", points}, {"high", high}});
}

void expect_same(const std::vector<Marker>& a, const std::vector<Marker>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n) {
    EXPECT_EQ(a[n].id, b[n].id);
    EXPECT_EQ(a[n].group, b[n].group);
    EXPECT_EQ(a[n].seeded_s, b[n].seeded_s);
    EXPECT_TRUE(a[n].X == b[n].X) << "marker " << a[n].id;
  }
}

TEST(Markers, GoTheSameWayOnAnyNumberOfRanks)
{
  Markers together = two_groups(), alone = two_groups();
  turn(together, grid_on(MPI_COMM_WORLD), 80, 2.0);
  turn(alone, grid_on(MPI_COMM_SELF), 80, 2.0);
  expect_same(together.gather(MPI_COMM_WORLD), alone.gather(MPI_COMM_SELF));
  EXPECT_EQ(together.lost(), alone.lost());
  EXPECT_GT(alone.lost(), 0);
  EXPECT_LT(alone.lost(), 40);
}

TEST(Markers, ACheckpointBringsThemBackAndKnowsWhoHasSetOut)
{
  const std::string path = shared_file("markers.h5");
  const Hierarchy grid = grid_on(MPI_COMM_WORLD);
  Markers before = two_groups(), after = two_groups();
  turn(before, grid, 80, 2.0);
  {
    Checkpoint c = Checkpoint::create(path, MPI_COMM_WORLD);
    before.save_or_restore(c, grid);
    c.close();
  }
  turn(after, grid, 1, 0.1);  // what is restored must not depend on what was there
  Checkpoint c = Checkpoint::open(path, MPI_COMM_WORLD);
  after.save_or_restore(c, grid);
  expect_same(after.gather(MPI_COMM_WORLD), before.gather(MPI_COMM_WORLD));
  EXPECT_EQ(after.lost(), before.lost());
  EXPECT_EQ(after.local().size(), before.local().size());
  after.seed_due(grid, turning_flow(grid, 2.0), 2.0);
  EXPECT_EQ(after.local().size(), before.local().size());
}

}  // namespace
}  // namespace valsalva::ib3d
