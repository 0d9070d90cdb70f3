// The solver knows its structure as an elastic model alone: a sheet of finite elements moves as on one box and one rank,
// wherever the boxes are cut, nodes that are lost are an error, and a step that is given up leaves no trace.
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "furthest_apart.hpp"
#include "ib3d/fluid/tube.hpp"
#include "ib3d/immersed_boundary.hpp"
#include "ib3d/structure/triangle_model.hpp"

namespace valsalva::ib3d {
namespace {

struct SheetInFlow {
  SheetInFlow(MPI_Comm comm, int boxes, const Vec3& slip = {0, 0, 0},
              StructureScheme scheme = StructureScheme::leapfrog)
      : solver(Hierarchy(walled_box({2, 2, 4}), 0.125, comm, boxes),
               {{"inlet", Side::z_lo, {1, 1, 0}, 0.6, "lv"}, {"outlet", Side::z_hi, {1, 1, 0}, 0.7, "ao"}},
               {1.0, 0.04, Advection::xsppm7, 0.4}, {"multilevel", 1e-11, 100},
               stretched_sheet({1, 1, 2}, 1.5, 24, 1.2, slip), scheme, timers)
  {
  }
  void advance(int steps, double tried_dt = 0)
  {
    for (int step = 0; step < steps; ++step) {
      if (tried_dt > 0) {
        solver.begin_step(tried_dt);
        solver.solve_fluid({900, -100});
      }
      solver.begin_step(1e-3);
      solver.solve_fluid({200, 100});
      solver.accept({1, 2});
    }
  }
  std::vector<Vec3> X() const { return solver.nodes().gather(solver.X()); }
  Timers timers;
  ImmersedBoundarySolver solver;
};

TEST(ElasticModel, FiniteElementsDoNotNoticeTheBoxes)
{
  SheetInFlow one(MPI_COMM_SELF, 1), all(MPI_COMM_WORLD, 0), many(MPI_COMM_WORLD, 8);
  const std::vector<Vec3> start = one.X();
  for (SheetInFlow* sheet : {&one, &all, &many}) sheet->advance(10);
  EXPECT_GT(furthest_apart(one.X(), start), 0.005);
  EXPECT_LT(furthest_apart(one.X(), all.X()), 1e-10);
  EXPECT_LT(furthest_apart(one.X(), many.X()), 1e-10);
  const double energy = one.solver.elastic_energy(), omega = one.solver.elastic_rate();
  EXPECT_GT(omega, 10);
  EXPECT_NEAR(many.solver.elastic_energy(), energy, 1e-9 * energy);
  EXPECT_NEAR(many.solver.elastic_rate(), omega, 1e-6 * omega);
}

TEST(ElasticModel, NodesSlipThroughTheFluidWithTheVelocityOfTheModel)
{
  SheetInFlow still(MPI_COMM_WORLD, 0), slipping(MPI_COMM_WORLD, 0, {0, 0, 30});
  for (SheetInFlow* sheet : {&still, &slipping}) sheet->advance(1);
  const std::vector<Vec3> a = still.X(), b = slipping.X();
  for (std::size_t n = 0; n < a.size(); ++n) EXPECT_LT(norm(b[n] - a[n] - Vec3{0, 0, 0.03}), 1e-14);
}

TEST(ElasticModel, ANodeThatIsLostIsAnErrorOnAllRanks)
{
  const Vec3 nowhere{0, 0, std::nan("")};
  SheetInFlow sheet(MPI_COMM_WORLD, 0, nowhere);
  EXPECT_THROW(sheet.advance(1), SolverError);
  // found before anything is sent, by the ranks that have such nodes
  SheetInFlow alone(MPI_COMM_SELF, 0, nowhere, StructureScheme::midpoint);
  EXPECT_THROW(alone.advance(1), SolverError);
}

TEST(ElasticModel, AStepThatIsGivenUpLeavesNoTrace)
{
  for (const StructureScheme scheme : {StructureScheme::leapfrog, StructureScheme::midpoint}) {
    SheetInFlow straight(MPI_COMM_WORLD, 0, {0, 0, 0}, scheme), again(MPI_COMM_WORLD, 0, {0, 0, 0}, scheme);
    straight.advance(12);
    again.advance(12, 0.7e-3);
    EXPECT_EQ(furthest_apart(straight.X(), again.X()), 0);
    EXPECT_EQ(straight.solver.courant_rate(), again.solver.courant_rate());
  }
}

}  // namespace
}  // namespace valsalva::ib3d
