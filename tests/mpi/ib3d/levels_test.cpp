// Structure and fluid on refined levels: the grid follows the structure, a fine level around it gives what a fine grid
// everywhere gives, and neither boxes nor ranks are noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/max_or_nan.hpp"
#include "furthest_apart.hpp"
#include "ib3d/fluid/tube.hpp"
#include "ib3d/immersed_boundary.hpp"
#include "ib3d/output/mpi_session.hpp"
#include "ib3d/output/probes.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"

namespace valsalva::ib3d {
namespace {

const Vec3 kSize{2, 2, 4};
constexpr double kH = 2.0 / 32;

/// A closed ring of springs under tension, out of round, that relaxes.
FibreNetwork ring(const Vec3& centre)
{
  FibreNetwork network;
  const int n = 80;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    network.X.push_back(centre + Vec3{0.4 * std::cos(a), 0.25 * std::sin(a), 0.1 * std::cos(a)});
    network.springs.add(i, (i + 1) % n, 30, 0.02, false);
  }
  return network;
}

std::vector<Opening> two_discs()
{
  return {{"inlet", Side::z_lo, {1, 1, 0}, 0.6, "lv"}, {"outlet", Side::z_hi, {1, 1, 0}, 0.7, "ao"}};
}

struct RingFlow {
  RingFlow(int levels, int boxes, MPI_Comm comm = MPI_COMM_WORLD, double tolerance = 1e-9)
  {
    RefinementPolicy policy;
    policy.levels = levels;
    const FibreNetwork network = ring({1, 1, 1.2});
    const Hierarchy grid(walled_box(kSize), kH, comm, refine(walled_box(kSize), kH, policy, network.X),
                         network.X, boxes);
    root = std::make_unique<ImmersedBoundarySolver>(
        grid, two_discs(), FluidParameters{}, PressureOptions{"multilevel", tolerance, 100},
        std::make_unique<FibreModel>(network), StructureScheme::leapfrog, timers, policy);
  }
  void advance(int steps, double dt, double p_in)
  {
    for (int step = 0; step < steps; ++step) {
      root->elastic_rate();  // also where a rank has no nodes
      root->begin_step(dt);
      root->solve_fluid({p_in, 0});
      root->accept({0, 0});
    }
  }
  std::vector<Vec3> X() const { return root->nodes().gather(root->X()); }
  Timers timers;
  std::unique_ptr<ImmersedBoundarySolver> root;
};

TEST(Levels, RefinedGridMovesTheStructureAsAFineGridDoes)
{
  RingFlow fine(1, 0), two(2, 0), three(3, 0);
  const std::vector<Vec3> start = fine.X();
  for (RingFlow* run : {&fine, &two, &three}) run->advance(60, 1e-3, 400);
  const double path = furthest_apart(start, fine.X());
  EXPECT_GT(path, 0.1);
  EXPECT_LT(furthest_apart(fine.X(), two.X()), 0.01 * path);
  EXPECT_LT(furthest_apart(fine.X(), three.X()), 0.01 * path);
  EXPECT_LT(two.root->grid().valid_cell_count(), fine.root->grid().valid_cell_count() / 2);
}

/// A sphere of meridians and parallels under tension.
FibreNetwork sphere(const Vec3& centre, double radius)
{
  FibreNetwork network;
  const int parallels = 31, meridians = 64;
  for (int j = 1; j <= parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      const double a = 2 * M_PI * i / meridians, b = M_PI * j / (parallels + 1);
      network.X.push_back(centre +
                          radius * Vec3{std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)});
    }
  const auto join = [&](int a, int b) {
    const Vec3 apart = network.X[static_cast<std::size_t>(a)] - network.X[static_cast<std::size_t>(b)];
    network.springs.add(a, b, 10, 0.5 * norm(apart), false);
  };
  for (int j = 0; j < parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      join(j * meridians + i, j * meridians + (i + 1) % meridians);
      if (j + 1 < parallels) join(j * meridians + i, (j + 1) * meridians + i);
    }
  return network;
}

TEST(Levels, PressureInASphereUnderTensionIsThatOfTheFineGrid)
{
  std::vector<double> jumps;
  for (const int levels : {1, 2, 3}) {
    RefinementPolicy policy;
    policy.levels = levels;
    const FibreNetwork network = sphere({1, 1, 2}, 0.45);
    const Hierarchy grid(walled_box(kSize), kH, MPI_COMM_WORLD,
                         refine(walled_box(kSize), kH, policy, network.X), network.X);
    Timers timers;
    ImmersedBoundarySolver root(grid, two_discs(), {}, {"multilevel", 1e-6, 100},
                                std::make_unique<FibreModel>(network), StructureScheme::leapfrog, timers,
                                policy);
    for (int step = 0; step < 3; ++step) {
      root.begin_step(1e-4);
      root.solve_fluid({0, 0});
      root.accept({0, 0});
    }
    const std::vector<double> p = pressure_at(root.grid(), root.fluid().p(), {{1, 1, 0.5}, {1, 1, 2.0}});
    jumps.push_back(p[1] - p[0]);
  }
  EXPECT_GT(jumps[0], 100);
  EXPECT_NEAR(jumps[1] / jumps[0], 1, 0.01);
  EXPECT_NEAR(jumps[2] / jumps[0], 1, 0.01);
}

TEST(Levels, GridFollowsTheStructure)
{
  RingFlow run(2, 0);
  const Refinement before = run.root->grid().refinement();
  run.advance(160, 1e-3, 400);
  const Hierarchy& grid = run.root->grid();
  EXPECT_NE(before, grid.refinement());
  double highest = 0;
  for (const Vec3& x : run.X()) {
    highest = max_or_nan(highest, x[2]);
    IndexBox support;
    for (std::size_t d = 0; d < 3; ++d) {
      support.lo[d] = static_cast<int>(std::floor(x[static_cast<int>(d)] / grid.finest().h)) - 2;
      support.hi[d] = support.lo[d] + 5;
    }
    std::vector<IndexBox> rest{intersect(support, grid.finest().box)};
    for (const Patch& p : grid.finest().patches) rest = without(rest, p.box);
    EXPECT_TRUE(rest.empty());
  }
  EXPECT_GT(highest, 2.0);
  EXPECT_LT(run.root->fluid().divergence_rms(), 1e-9);
}

TEST(Levels, ARunContinuedAfterARegridRepeatsItToTheBit)
{
  const std::string path = shared_file("regrid.h5");
  RingFlow whole(2, 0), second(2, 0);
  whole.advance(90, 1e-3, 400);
  const Refinement boxes = whole.root->grid().refinement();
  EXPECT_NE(boxes, second.root->grid().refinement());
  Checkpoint out = Checkpoint::create(path, MPI_COMM_WORLD);
  whole.root->save_or_restore(out);
  out.close();
  Checkpoint in = Checkpoint::open(path, MPI_COMM_WORLD);
  second.root->save_or_restore(in);
  EXPECT_EQ(boxes, second.root->grid().refinement());
  for (RingFlow* run : {&whole, &second}) run->advance(30, 1e-3, 400);
  const std::vector<Vec3> a = whole.X(), b = second.X();
  for (std::size_t n = 0; n < a.size(); ++n)
    for (int d = 0; d < 3; ++d) EXPECT_EQ(a[n][d], b[n][d]);
}

TEST(Levels, BoxesAndRanksAreNotNoticed)
{
  RingFlow one(3, 0, MPI_COMM_SELF, 1e-11), all(3, 0, MPI_COMM_WORLD, 1e-11),
      many(3, 7, MPI_COMM_WORLD, 1e-11);
  for (RingFlow* run : {&one, &all, &many}) run->advance(20, 1e-3, 400);
  EXPECT_LT(furthest_apart(one.X(), all.X()), 1e-10);
  EXPECT_LT(furthest_apart(one.X(), many.X()), 1e-10);
}

}  // namespace
}  // namespace valsalva::ib3d
