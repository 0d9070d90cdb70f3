// Fluid and structure together do not notice how the domain is cut into boxes: velocity and nodes after some
// steps on many boxes and ranks are those of one box on one rank, also where nodes sit on the cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/max_or_nan.hpp"
#include "furthest_apart.hpp"
#include "ib3d/fluid/tube.hpp"
#include "ib3d/immersed_boundary.hpp"
#include "ib3d/output/mpi_session.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "ib3d/structure/random_network.hpp"

namespace valsalva::ib3d {
namespace {

const Vec3 kSize{2, 2, 4};

/// A tangle of strong springs across the whole box.
FibreNetwork tangle()
{
  FibreNetwork network = random_network(150, 5);
  for (Vec3& x : network.X) x = {1 + 0.95 * x[0], 1 + 0.95 * x[1], 2 + 1.95 * x[2]};
  for (double& k : network.springs.stiffness) k *= 20;
  return network;
}

std::vector<Opening> two_discs()
{
  return {{"inlet", Side::z_lo, {1, 1, 0}, 0.6, "lv"}, {"outlet", Side::z_hi, {1, 1, 0}, 0.7, "ao"}};
}

struct TangleRun {
  TangleRun(MPI_Comm comm, int boxes, StructureScheme scheme, double fold_relaxation = 0)
      : grid(walled_box(kSize), 0.125, comm, boxes),
        root(grid, two_discs(), {}, {"multilevel", 1e-11, 100},
             std::make_unique<FibreModel>(tangle(), fold_relaxation), scheme, timers)
  {
    advance();
  }
  void advance()
  {
    for (int step = 0; step < 4; ++step) {
      root.begin_step(1e-3);
      root.solve_fluid({200, 100});
      root.accept({1, 2});
    }
  }
  Timers timers;
  Hierarchy grid;
  ImmersedBoundarySolver root;
};

/// Largest velocity of `one` (one box on every rank), and largest difference of `many` from it.
void compare(const TangleRun& one, const TangleRun& many, double& speed, double& difference)
{
  const Level& level = many.grid.finest();
  speed = difference = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_index(faces_of(level.local_box(p), c), [&](int i, int j, int k) {
        const double expected = one.root.fluid().u()[0](0, c)(i, j, k);
        speed = max_or_nan(speed, std::abs(expected));
        difference = max_or_nan(difference, std::abs(many.root.fluid().u()[0](p, c)(i, j, k) - expected));
      });
  speed = Communicator(MPI_COMM_WORLD).max(speed);
  difference = Communicator(MPI_COMM_WORLD).max(difference);
}

std::vector<Vec3> positions(const TangleRun& run)
{
  return run.root.nodes().gather(run.root.X());
}

void expect_the_same(int boxes, StructureScheme scheme, double fold_relaxation = 0)
{
  const TangleRun one(MPI_COMM_SELF, 1, scheme, fold_relaxation),
      many(MPI_COMM_WORLD, boxes, scheme, fold_relaxation);
  double speed = 0, difference = 0;
  compare(one, many, speed, difference);
  EXPECT_GT(speed, 0.1);
  EXPECT_LT(difference / speed, 1e-9) << boxes << " boxes";
  EXPECT_LT(furthest_apart(positions(one), positions(many)), 1e-11 * speed);
}

TEST(ImmersedBoundarySolver, LeapfrogDoesNotNoticeTheBoxes)
{
  expect_the_same(0, StructureScheme::leapfrog);
  expect_the_same(8, StructureScheme::leapfrog);
}

TEST(ImmersedBoundarySolver, MidpointDoesNotNoticeTheBoxes)
{
  expect_the_same(0, StructureScheme::midpoint);
  expect_the_same(6, StructureScheme::midpoint);
}

TEST(ImmersedBoundarySolver, FoldsFlattenWhateverTheBoxes)
{
  const TangleRun with(MPI_COMM_SELF, 1, StructureScheme::leapfrog, 4e-3),
      without(MPI_COMM_SELF, 1, StructureScheme::leapfrog);
  ASSERT_GT(furthest_apart(positions(with), positions(without)), 0.01);
  expect_the_same(8, StructureScheme::leapfrog, 4e-3);
  expect_the_same(6, StructureScheme::midpoint, 4e-3);
}

TEST(ImmersedBoundarySolver, FoldsFlattenOnBitForBitAfterARestart)
{
  const std::string path = shared_file("folds.h5");
  TangleRun whole(MPI_COMM_WORLD, 8, StructureScheme::leapfrog, 4e-3),
      second(MPI_COMM_WORLD, 8, StructureScheme::leapfrog, 4e-3);
  Checkpoint written = Checkpoint::create(path, MPI_COMM_WORLD);
  whole.root.save_or_restore(written);
  written.close();
  whole.advance();
  second.advance();  // what is restored must not depend on what was there
  Checkpoint read = Checkpoint::open(path, MPI_COMM_WORLD);
  second.root.save_or_restore(read);
  second.advance();
  EXPECT_EQ(positions(second), positions(whole));
}

}  // namespace
}  // namespace valsalva::ib3d
