// Order and stability of the two coupling schemes against the closed form of a frictionless tube.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/max_or_nan.hpp"
#include "coupling/tube_model.hpp"

namespace valsalva::coupling {

namespace {

constexpr double kEnd_s = 0.06;

/// Flow and pressure after 0.06 s, as errors relative to the steady flow and to p_in.
Eigen::Vector2d error(CouplingScheme scheme, double dt)
{
  const TubeLoad load;
  TubeModel tube = tube_with_fixed_step(load, scheme, dt);
  while (tube.model.t() < kEnd_s - 1e-12) tube.model.advance(tube.model.next_step(kEnd_s));
  const Eigen::Vector2d exact = exact_tube(load, kEnd_s);
  return {(tube.flow() - exact[0]) / exact[0], (tube.circulation.state().y[0] - exact[1]) / load.p_in};
}

std::vector<double> orders(CouplingScheme scheme)
{
  const Eigen::Vector2d coarse = error(scheme, 1e-3), fine = error(scheme, 5e-4);
  return {std::log2(std::abs(coarse[0] / fine[0])), std::log2(std::abs(coarse[1] / fine[1]))};
}

TEST(CoupledModel, ImplicitSchemeIsSecondOrder)
{
  const std::vector<double> order = orders(CouplingScheme::implicit_);
  RecordProperty("flow", std::to_string(order[0]));
  RecordProperty("pressure", std::to_string(order[1]));
  EXPECT_NEAR(order[0], 2.0, 0.15);
  EXPECT_NEAR(order[1], 2.0, 0.15);
  EXPECT_LT(error(CouplingScheme::implicit_, 5e-4).norm(), 1e-3);
}

TEST(CoupledModel, ExplicitSchemeIsFirstOrder)
{
  const std::vector<double> order = orders(CouplingScheme::explicit_);
  RecordProperty("flow", std::to_string(order[0]));
  RecordProperty("pressure", std::to_string(order[1]));
  EXPECT_NEAR(order[0], 1.0, 0.2);
  EXPECT_NEAR(order[1], 1.0, 0.2);
}

TEST(CoupledModel, InertanceOfTheTubeIsRhoLengthOverArea)
{
  const TubeModel tube = tube_with_fixed_step({}, CouplingScheme::implicit_, 1e-3);
  EXPECT_NEAR(tube.model.inertance(0) / kTubeInertance, 1.0, 1e-6);
  EXPECT_NEAR(tube.model.inertance(1) / kTubeInertance, 1.0, 1e-6);
}

/// Growth per step of the flow's distance from its steady value, fitted between the first and the last quarter
/// of `steps` steps: below 1 the scheme settles.
double growth_per_step(CouplingScheme scheme, const TubeLoad& load, double dt, int steps)
{
  TubeModel tube = tube_with_fixed_step(load, scheme, dt);
  const double steady = load.p_in / (load.Rc + load.Rp);
  double first = 0, last = 0;
  for (int n = 0; n < steps; ++n) {
    tube.model.advance(tube.model.next_step(1e9));
    const double distance = std::abs(tube.flow() - steady);
    if (n < steps / 4) first = max_or_nan(first, distance);
    if (n >= steps - steps / 4) last = max_or_nan(last, distance);
  }
  return std::pow(last / first, 1.0 / (steps - steps / 4));
}

/// Largest modulus of the eigenvalues of one explicit step (pressures from t^n, the Windkessel then advanced
/// exactly with the new flow): Q' = Q - (dt/L)(Pc + Rc Q), Pc' = e Pc + Rp (1 - e) Q'.
double explicit_amplification(const TubeLoad& load, double dt)
{
  const double e = std::exp(-dt / (load.Rp * load.C));
  Eigen::Matrix2d step;
  step.row(0) << 1 - dt * load.Rc / kTubeInertance, -dt / kTubeInertance;
  step.row(1) = load.Rp * (1 - e) * step.row(0) + Eigen::RowVector2d(0, e);
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

double explicit_limit(const TubeLoad& load)
{
  return lumped::testing::bisect([&](double dt) { return explicit_amplification(load, dt) - 1; }, 1e-4, 0.1);
}

TEST(CoupledModel, ExplicitSchemeIsStableUpToItsLimitAndGrowsBeyond)
{
  // Small pressures, so that a growing flow does not end the run by its CFL number.
  const TubeLoad load{0.02, 5.0, 0.1, 1e-6};
  const double limit = explicit_limit(load);
  for (const double factor : {0.6, 1.02}) {
    const double expected = explicit_amplification(load, factor * limit);
    EXPECT_EQ(expected > 1, factor > 1);
    EXPECT_NEAR(growth_per_step(CouplingScheme::explicit_, load, factor * limit, 40), expected,
                0.2 * std::abs(expected - 1));
  }
}

TEST(CoupledModel, ImplicitSchemeSettlesFarBeyondTheExplicitLimit)
{
  const TubeLoad load{0.02, 5.0, 0.1, 1e-6};
  const double limit = explicit_limit(load);
  for (const double factor : {1.5, 5.0, 20.0})
    EXPECT_LT(growth_per_step(CouplingScheme::implicit_, load, factor * limit, 80), 0.999) << factor;
}

}  // namespace
}  // namespace valsalva::coupling
