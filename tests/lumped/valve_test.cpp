#include "lumped/elements/valve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

TEST(Valve, WithInertanceOpensAndClosesAtTheExactTimes)
{
  // The pressure drop rises through zero at 0.2 s, peaks at 0.4 s, and falls.
  const double R = 0.05, L = 0.002, tau = L / R, up = 50.0, down = -60.0;
  const LumpedNetwork network({{pressure_table("a", "a", {0.0, 0.4, 1.0}, {-10.0, 10.0, -26.0}),
                                valve("v", "a", "b", R, L), pressure_source("b", "b", 0.0)},
                               {},
                               0.0});
  // L Q' + R Q = dp0 + k s, Q(0) = Q0
  const auto flow = [&](double Q0, double dp0, double k, double s) {
    const auto particular = [&](double x) { return (dp0 + k * (x - tau)) / R; };
    return particular(s) + (Q0 - particular(0.0)) * std::exp(-s / tau);
  };
  const double at_peak = flow(0.0, 0.0, up, 0.2);
  const double closing = bisect([&](double t) { return flow(at_peak, 10.0, down, t - 0.4); }, 0.5, 1.0);

  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  ASSERT_EQ(state.valve_open[0], 0);
  EXPECT_NEAR(switching_time(integrator, state, 0.4), 0.2, 1e-9);
  integrator.advance(state, 0.4, {}, {});
  EXPECT_EQ(state.valve_open[0], 1);
  EXPECT_NEAR(state.y[0], at_peak, 1e-8 * at_peak);
  EXPECT_NEAR(switching_time(integrator, state, 1.0), closing, 1e-9);
  integrator.advance(state, 1.0, {}, {});
  EXPECT_EQ(state.valve_open[0], 0);
  EXPECT_EQ(state.y[0], 0.0);
}

TEST(Valve, WithoutInertanceOpensWhereTheSourceOvertakesTheWindkessel)
{
  const double R = 0.02, rate = 400.0, tau = 0.79 * 1.75;
  const LumpedNetwork network({{pressure_table("heart", "lv", {0.0, 0.5}, {0.0, rate * 0.5}),
                                valve("aortic", "lv", "ao", R), windkessel("arteries", "ao")},
                               {},
                               0.0});
  const double opening = bisect([&](double t) { return rate * t - 85.0 * std::exp(-t / tau); }, 0.0, 0.5);
  CvodeIntegrator integrator(network, 1e-11);
  const LumpedState start = network.initial_state();
  EXPECT_NEAR(switching_time(integrator, start, 0.5), opening, 1e-9);
}

TEST(Valve, WithoutInertanceItsFlowFollowsThePressuresAtOnce)
{
  const double R = 0.02, Rc = 0.033, Rp = 0.79, C = 1.75, P = 120.0;
  const LumpedNetwork network(
      {{pressure_source("heart", "lv", P), valve("aortic", "lv", "ao", R), windkessel("arteries", "ao")},
       {},
       0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  integrator.advance(state, 0.1, {}, {});
  // C Pc' = (P - Pc)/(R + Rc) - Pc/Rp
  const double rate = (1.0 / (R + Rc) + 1.0 / Rp) / C, steady = P / (R + Rc) / (rate * C);
  const double Pc = steady + (85.0 - steady) * std::exp(-rate * 0.1);
  EXPECT_NEAR(state.y[0], Pc, 1e-8 * Pc);
  EXPECT_NEAR(observed(network, state, "Q_aortic_ml_s"), (P - Pc) / (R + Rc), 1e-5);
  EXPECT_NEAR(observed(network, state, "Q_heart_ml_s"), (P - Pc) / (R + Rc), 1e-5);
  EXPECT_NEAR(observed(network, state, "p_ao_mmHg"), Pc + Rc * (P - Pc) / (R + Rc), 1e-6);
}

TEST(Valve, BernoulliLossGivesTheQuadraticSteadyFlow)
{
  const double R = 0.01, B = 2e-5, dp = 12.0;
  const double steady = (-R + std::sqrt(R * R + 4.0 * B * dp)) / (2.0 * B);
  for (double L : {0.0, 0.0005}) {
    const LumpedNetwork network(
        {{pressure_source("a", "a", 92.0), valve("v", "a", "b", R, L, B), pressure_source("b", "b", 80.0)},
         {},
         0.0});
    CvodeIntegrator integrator(network, 1e-10);
    LumpedState state = network.initial_state();
    integrator.advance(state, 2.0, {}, {});
    EXPECT_NEAR(observed(network, state, "Q_v_ml_s"), steady, 1e-7 * steady) << "L = " << L;
  }
}

TEST(Valve, AGrazingPressureDoesNotMakeItChatter)
{
  // The pressure drop rises to zero exactly, rests there, and falls again, ten times.
  std::vector<double> t, p;
  for (int i = 0; i < 10; ++i)
    for (double s : {0.0, 0.03, 0.06}) {
      t.push_back(0.1 * i + s);
      p.push_back(s == 0.0 ? -5.0 : 0.0);
    }
  for (double L : {0.0, 0.001}) {
    const LumpedNetwork network({{pressure_table("a", "a", t, p), valve("v", "a", "b", 0.01, L),
                                  windkessel("w", "b", 0.0, 1e9, 1e9, 0.0)},
                                 {},
                                 0.0});
    CvodeIntegrator integrator(network);
    LumpedState state = network.initial_state();
    integrator.advance(state, 0.99, {}, {});
    EXPECT_LE(integrator.statistics().events, 20);
    EXPECT_NEAR(state.y[0], 0.0, 1e-9);
  }
}

TEST(Valve, ANetworkWithoutStatesFollowsItsSources)
{
  const LumpedNetwork network({{pressure_table("a", "a", {0.0, 1.0}, {-10.0, 10.0}),
                                valve("v", "a", "b", 0.1), pressure_source("b", "b", 0.0)},
                               {},
                               0.0});
  ASSERT_EQ(network.state_count(), 0);
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  integrator.advance(state, 0.4, {}, {});
  EXPECT_EQ(observed(network, state, "Q_v_ml_s"), 0.0);
  integrator.advance(state, 0.75, {}, {});
  EXPECT_DOUBLE_EQ(observed(network, state, "Q_v_ml_s"), 50.0);
}

}  // namespace valsalva::lumped::testing
