#include "lumped/elements/windkessel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

constexpr double Rc = 0.033, Rp = 0.79, C = 1.75, P0 = 85.0;
constexpr double tau = Rp * C;

/// Pc at s after Pc(0) = start with the inflow a + b s.
double pressure_after_ramp(double start, double a, double b, double s)
{
  return Rp * (a + b * (s - tau)) + (start - Rp * (a - b * tau)) * std::exp(-s / tau);
}

}  // namespace

TEST(Windkessel3, StepFlowGivesExponentialPressure)
{
  ElementSpec arteries = windkessel("arteries", "ao");
  arteries.numbers["distal_pressure_mmHg"] = 5.0;
  const LumpedNetwork network({{arteries}, {"ao"}, 0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  const std::vector<double> Q = {90.0};
  for (double t : {0.01, 0.3, 2.0}) {
    integrator.advance(state, t, Q, Q);
    const double steady = 5.0 + Rp * 90.0;
    const double exact = steady + (P0 - steady) * std::exp(-t / tau) + Rc * 90.0;
    EXPECT_NEAR(integrator.port_pressures(state, Q)[0], exact, 1e-8 * exact);
  }
}

TEST(Windkessel3, HalfSineFlowGivesTheClosedFormPressure)
{
  const LumpedNetwork network({{windkessel("arteries", "ao")}, {"ao"}, 0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  const double peak = 450.0, ejection = 0.3, w = std::numbers::pi / ejection;
  const int steps = 20000;  // linear pieces: the interpolation of the sine is 3e-9 of its peak off
  for (int i = 0; i < steps; ++i) {
    const double t0 = ejection * i / steps, t1 = ejection * (i + 1) / steps;
    const double Q0 = peak * std::sin(w * t0), Q1 = peak * std::sin(w * t1);
    integrator.advance(state, t1, std::vector{Q0}, std::vector{Q1});
  }
  // C Pc' + Pc/Rp = peak sin(w t)
  const double amplitude = peak * Rp / (1.0 + w * w * tau * tau);
  const double exact = (P0 + amplitude * w * tau) * std::exp(-ejection / tau) +
                       amplitude * (std::sin(w * ejection) - w * tau * std::cos(w * ejection));
  EXPECT_NEAR(state.y[0], exact, 1e-8 * exact);
}

TEST(Windkessel3, PiecewiseLinearSourceIsIntegratedAcrossItsKinks)
{
  const std::vector<double> t = {0.0, 0.1, 0.25, 0.3}, Q = {0.0, 400.0, 50.0, 0.0};
  const LumpedNetwork network({{windkessel("arteries", "ao"), flow_table("heart", "ao", t, Q)}, {}, 0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  integrator.advance(state, 0.8, {}, {});
  double exact = P0;
  for (std::size_t i = 0; i + 1 < t.size(); ++i)
    exact = pressure_after_ramp(exact, Q[i], (Q[i + 1] - Q[i]) / (t[i + 1] - t[i]), t[i + 1] - t[i]);
  exact = pressure_after_ramp(exact, 0.0, 0.0, 0.5);
  EXPECT_NEAR(state.y[0], exact, 1e-8 * exact);
}

TEST(Windkessel3, DefaultToleranceIsGoodToTheFifthDecimal)
{
  const LumpedNetwork network({{windkessel("arteries", "ao")}, {"ao"}, 0.0});
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  double exact = P0;
  const double dt = 1e-4;
  for (int i = 0; i < 8000; ++i) {  // as the coupling to the 3D solver does it, one beat
    const double Q0 = 100.0 + 80.0 * std::sin(8.0 * i * dt), Q1 = 100.0 + 80.0 * std::sin(8.0 * (i + 1) * dt);
    integrator.advance(state, (i + 1) * dt, std::vector{Q0}, std::vector{Q1});
    exact = pressure_after_ramp(exact, Q0, (Q1 - Q0) / dt, dt);
  }
  EXPECT_NEAR(state.y[0], exact, 1e-5);
}

TEST(Windkessel3, WithoutCharacteristicResistanceTheNodeHasThePressureOfTheCompliance)
{
  const LumpedNetwork network({{windkessel("arteries", "ao", 0.0)}, {"ao"}, 0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  const std::vector<double> Q = {200.0};
  integrator.advance(state, 0.2, Q, Q);
  EXPECT_EQ(integrator.port_pressures(state, Q)[0], state.y[0]);
  const double exact = pressure_after_ramp(P0, 200.0, 0.0, 0.2);
  EXPECT_NEAR(state.y[0], exact, 1e-8 * exact);
}

TEST(Windkessel3, WhilePressurisingTheNodeFollowsTheRampAndTheComplianceIsHeld)
{
  const LumpedNetwork network(aortic_root());
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  const std::vector<double> Q = {0.0, 30.0};
  EXPECT_EQ(integrator.port_pressures(state, Q)[1], 0.0);
  integrator.advance(state, 0.02, Q, Q);
  EXPECT_DOUBLE_EQ(integrator.port_pressures(state, Q)[1], P0 * 0.02 / 0.05);
  EXPECT_EQ(state.y[0], P0);
  integrator.advance(state, 0.05, Q, Q);
  EXPECT_EQ(state.y[0], P0);
  EXPECT_DOUBLE_EQ(integrator.port_pressures(state, Q)[1], P0 + Rc * 30.0);
  integrator.advance(state, 0.15, Q, Q);
  EXPECT_NEAR(state.y[0], pressure_after_ramp(P0, 30.0, 0.0, 0.1), 1e-8 * P0);
}

}  // namespace valsalva::lumped::testing
