// From the text of a case to a running model.
#include <gtest/gtest.h>

#include <cmath>

#include "complaint.hpp"
#include "coupling/small_cases.hpp"
#include "setup/build_model.hpp"

namespace valsalva::setup {

using namespace coupling;
namespace {

Case exact_tube(Changes changes = {})
{
  changes.insert(changes.end(), {"time.dt_fixed_s=1e-3", "pressure.divergence_tolerance_1_s=1e-7"});
  return tube_case(changes);
}

TEST(CaseModel, FlowInIsFlowOutBetweenWalls)
{
  Timers timers;
  CaseModel model(exact_tube(), Communicator(MPI_COMM_SELF), timers);
  const double volume = 2 * 2 * 4;
  for (int n = 0; n < 3; ++n) {
    const StepReport step = model.model().advance(model.model().next_step(0.01));
    const std::vector<double>& Q = model.model().interface().flow_ml_s;
    EXPECT_LT(step.divergence_rms, 1e-7);
    EXPECT_GT(Q[1], 0.5 * (n + 1));
    EXPECT_LT(std::abs(Q[0] + Q[1]), 1e-7 * volume);  // Cauchy-Schwarz
  }
  EXPECT_EQ(model.model().step(), 3);
}

TEST(CaseModel, FlowOfTheInterfaceIsTheFlowOfTheVelocity)
{
  Timers timers;
  CaseModel model(exact_tube(), Communicator(MPI_COMM_SELF), timers);
  for (int n = 0; n < 3; ++n) model.model().advance(model.model().next_step(0.01));
  const ib3d::NavierStokes& fluid = model.solver().fluid();
  const std::vector<double> Q = ib3d::OpeningFaces(fluid.grid(), fluid.openings()).flow(fluid.u());
  for (std::size_t m = 0; m < 2; ++m) EXPECT_NEAR(Q[m] / model.model().interface().flow_ml_s[m], 1.0, 1e-7);
}

TEST(CaseModel, OpenSidesLetFluidOutBetweenTheOpenings)
{
  Timers timers;
  CaseModel model(exact_tube({"domain.sides=open"}), Communicator(MPI_COMM_SELF), timers);
  for (int n = 0; n < 3; ++n) model.model().advance(model.model().next_step(0.01));
  const std::vector<double>& Q = model.model().interface().flow_ml_s;
  EXPECT_LT(Q[0], 0);
  EXPECT_LT(Q[1], 0);  // both ends are above the pressure outside, 0
}

TEST(CaseModel, OpeningsThatOverlapOrLeaveTheBoxAreRefused)
{
  EXPECT_NE(complaint([] { exact_tube({"opening.inlet.radius_cm=1.1"}); }).find("outside the box"),
            std::string::npos);
  EXPECT_NE(complaint([] { exact_tube({"opening.outlet.side=z_lo"}); }).find("overlap"), std::string::npos);
}

}  // namespace
}  // namespace valsalva::setup
