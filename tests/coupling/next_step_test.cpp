// Step control: steps end exactly where something happens, and grow gently.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"
#include "coupling/tube_model.hpp"

namespace valsalva::coupling {

namespace {

lumped::NetworkSpec network_with_kinks()
{
  lumped::NetworkSpec spec = tube_network({});
  spec.elements[0] =
      lumped::testing::pressure_table("source", "lv", {0.0, 0.00731, 0.0123, 0.0314}, {0, 1, 0.5, 0.2});
  spec.elements[1].numbers["pressurise_s"] = 0.0211;
  return spec;
}

/// Times between steps until `end`, with a stop at every multiple of 0.01.
std::vector<double> times(TubeModel& tube, double end)
{
  std::vector<double> t{tube.model.t()};
  for (int stops = 1; t.back() < end - 1e-12; stops += t.back() > 0.01 * stops - 1e-12 ? 1 : 0) {
    tube.model.advance(tube.model.next_step(std::min(end, 0.01 * stops)));
    t.push_back(tube.model.t());
  }
  return t;
}

void expect_visits(const std::vector<double>& t)
{
  for (const double due : {0.00731, 0.01, 0.0123, 0.02, 0.0211, 0.03, 0.0314, 0.04}) {
    double nearest = 1;
    for (double x : t) nearest = min_or_nan(nearest, std::abs(x - due));
    EXPECT_LT(nearest, 1e-12) << due;
  }
}

TEST(NextStep, AutomaticStepsLandOnKinksAndStops)
{
  StepControl control;
  control.dt_max_s = 7e-4;
  TubeModel tube(network_with_kinks(), CouplingScheme::implicit_, control);
  const std::vector<double> t = times(tube, 0.04);
  expect_visits(t);
  for (std::size_t n = 1; n < t.size(); ++n) EXPECT_LE(t[n] - t[n - 1], 7e-4 * (1 + 1e-9));
  for (std::size_t n = 2; n < t.size(); ++n) EXPECT_LE(t[n] - t[n - 1], 1.16 * (t[n - 1] - t[n - 2]));
  // No step is wasted on a sliver: a target in reach is approached in equal steps.
  EXPECT_LE(t.size(), 75U);
}

TEST(NextStep, FixedStepsLandOnKinksAndStopsToo)
{
  StepControl control;
  control.dt_fixed_s = 7e-4;
  TubeModel tube(network_with_kinks(), CouplingScheme::implicit_, control);
  expect_visits(times(tube, 0.04));
}

TEST(NextStep, FixedStepIsKeptWhereNothingIsNear)
{
  StepControl control;
  control.dt_fixed_s = 1e-3;
  TubeModel tube = {tube_network({}), CouplingScheme::implicit_, control};
  EXPECT_EQ(tube.model.next_step(1.0).dt, 1e-3);
  EXPECT_EQ(tube.model.next_step(1.0).limited_by, ib3d::Limit::fixed);
  EXPECT_EQ(tube.model.next_step(1e-3).dt, 1e-3);
  EXPECT_NEAR(tube.model.next_step(1.5e-3).dt, 0.75e-3, 1e-15);
  EXPECT_EQ(tube.model.next_step(1.5e-3).limited_by, ib3d::Limit::target);
}

TEST(NextStep, CflBoundHoldsForTheFlowThatIsReached)
{
  StepControl control;
  control.dt_max_s = 1e-2;
  control.cfl = 0.1;
  TubeModel tube(tube_network({0.05, 1.0, 0.2, 3.0}), CouplingScheme::implicit_, control);
  bool limited = false;
  tube.model.advance({1e-4, ib3d::Limit::longest});
  for (int n = 0; n < 40; ++n) {
    const StepReport step = tube.model.advance(tube.model.next_step(1e9));
    EXPECT_LT(step.cfl, 0.1 * 1.25);
    limited = limited || step.limited_by == ib3d::Limit::cfl;
  }
  EXPECT_TRUE(limited);
}

TEST(NextStep, AStepFarBeyondTheCflBoundIsTold)
{
  StepControl control;
  control.dt_fixed_s = 0.5;
  TubeModel tube(tube_network({}), CouplingScheme::implicit_, control);
  EXPECT_THROW(tube.model.advance(tube.model.next_step(1e9)), SolverError);
}

}  // namespace
}  // namespace valsalva::coupling
