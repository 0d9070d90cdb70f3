#include "lumped/integration/cvode_integrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

TEST(CvodeIntegrator, AdvancingTwiceFromTheSameStateIsBitwiseEqual)
{
  const LumpedNetwork network(left_heart());
  CvodeIntegrator integrator(network), fresh(network);
  LumpedState start = network.initial_state();
  integrator.advance(start, 0.05, {}, {});  // shortly before the aortic valve opens
  LumpedState first = start, second = start, third = start, other = network.initial_state();
  integrator.advance(first, 0.37, {}, {});
  integrator.advance(other, 3.3, {}, {});
  integrator.advance(second, 0.37, {}, {});
  fresh.advance(third, 0.37, {}, {});
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
  EXPECT_NE(first.y, start.y);
}

TEST(CvodeIntegrator, AHundredShortAdvancesAgreeWithOneLong)
{
  NetworkSpec spec = left_heart();
  spec.ports = {"ao"};
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network, 1e-10);
  LumpedState once = network.initial_state(), split = once;
  const auto Q = [](double t) { return std::vector{10.0 + 100.0 * t}; };
  integrator.advance(once, 0.5, Q(0.0), Q(0.5));
  for (int i = 0; i < 100; ++i) integrator.advance(split, 0.005 * (i + 1), Q(0.005 * i), Q(0.005 * (i + 1)));
  for (std::size_t i = 0; i < once.y.size(); ++i)
    EXPECT_NEAR(once.y[i], split.y[i], 1e-7 * (1.0 + std::abs(once.y[i]))) << network.states()[i].name;
}

TEST(CvodeIntegrator, LandsExactlyAndPassesIntervalsThatAreTooShort)
{
  const LumpedNetwork network(aortic_root());
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  const std::vector<double> Q = {0.0, 100.0};
  integrator.advance(state, 0.3, Q, Q);
  EXPECT_EQ(state.t, 0.3);
  const double before = state.y[0];
  integrator.advance(state, 0.3, Q, Q);
  EXPECT_EQ(state.y[0], before);
  integrator.advance(state, std::nextafter(0.3, 1.0), Q, Q);
  EXPECT_EQ(state.t, std::nextafter(0.3, 1.0));
  EXPECT_NEAR(state.y[0], before, 1e-10);
  integrator.advance(state, 0.3 + 1e-11, Q, Q);
  EXPECT_NEAR(state.y[0], before, 1e-8);
}

TEST(CvodeIntegrator, AFailureIsASentenceAndLeavesTheState)
{
  const LumpedNetwork network(aortic_root());
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  const std::vector<double> Q = {0.0, 100.0};
  integrator.advance(state, 0.2, Q, Q);
  const LumpedState before = state;
  const std::vector<double> bad = {0.0, std::numeric_limits<double>::quiet_NaN()};
  try {
    integrator.advance(state, 0.3, Q, bad);
    FAIL() << "a flow that is not a number was accepted";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("from t = 0.2 s"), std::string::npos) << error.what();
  }
  EXPECT_EQ(state, before);
  EXPECT_THROW(integrator.advance(state, 0.1, Q, Q), SolverError);
  EXPECT_THROW(integrator.advance(state, 0.3, std::vector{1.0}, Q), SolverError);
  integrator.advance(state, 0.3, Q, Q);
  EXPECT_EQ(state.t, 0.3);
}

TEST(CvodeIntegrator, KinksOfTheProtocolAreKnown)
{
  const LumpedNetwork network(aortic_root());
  double t = -1.0;
  for (double kink : {0.0, 0.05, 0.15, 0.35, 0.45, 0.8}) {
    t = network.next_kink(t);
    EXPECT_EQ(t, kink);
  }
  EXPECT_EQ(network.next_kink(t), std::numeric_limits<double>::infinity());
}

TEST(CvodeIntegrator, ARepeatedTableRepeats)
{
  ElementSpec source = flow_table("heart", "ao", {0.0, 0.1, 0.3}, {0.0, 400.0, 0.0});
  source.words["beyond_table"] = "repeat";
  const LumpedNetwork network({{windkessel("arteries", "ao"), source}, {}, 0.8});
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  integrator.advance(state, 40.0 * 0.8, {}, {});
  const double a = state.y[0];
  EXPECT_NEAR(observed(network, state, "Q_heart_ml_s"), 0.0, 1e-9);
  integrator.advance(state, 40.0 * 0.8 + 0.05, {}, {});
  EXPECT_NEAR(observed(network, state, "Q_heart_ml_s"), 200.0, 1e-9);
  integrator.advance(state, 41.0 * 0.8, {}, {});
  EXPECT_NEAR(state.y[0], a, 1e-6);
  EXPECT_NEAR(network.next_kink(40.0 * 0.8), 40.0 * 0.8 + 0.1, 1e-12);
}

TEST(LeftHeart, HasAPlausiblePeriodicBeatWhoseMeanPressureIsResistanceTimesOutput)
{
  const LumpedNetwork network(left_heart());
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  const double T = 0.8;
  integrator.advance(state, 30.0 * T, {}, {});
  const LumpedState start = state;
  const long events = integrator.statistics().events;
  const int samples = 4000;
  double mean = 0.0, lowest = 1e9, highest = 0.0, largest_V = 0.0, smallest_V = 1e9, peak_flow = 0.0;
  for (int i = 1; i <= samples; ++i) {
    integrator.advance(state, start.t + T * i / samples, {}, {});
    const double p = observed(network, state, "p_ao_mmHg"), V = state.y[0];
    mean += p / samples;
    lowest = min_or_nan(lowest, p);
    highest = max_or_nan(highest, p);
    largest_V = max_or_nan(largest_V, V);
    smallest_V = min_or_nan(smallest_V, V);
    peak_flow = max_or_nan(peak_flow, observed(network, state, "Q_aortic_ml_s"));
  }
  const double stroke_volume = largest_V - smallest_V;
  EXPECT_EQ(network.states()[0].name, "ventricle.V_ml");
  EXPECT_EQ(network.states()[1].name, "aortic.Q_ml_s");
  EXPECT_EQ(network.states()[2].name, "arteries.Pc_mmHg");
  EXPECT_NEAR(state.y[2], start.y[2], 2e-5);
  EXPECT_EQ(integrator.statistics().events - events, 4);
  EXPECT_GT(stroke_volume, 60.0);
  EXPECT_LT(stroke_volume, 110.0);
  EXPECT_GT(highest, 100.0);
  EXPECT_LT(highest, 150.0);
  EXPECT_GT(lowest, 50.0);
  EXPECT_LT(lowest, 90.0);
  // An independent program (SciPy's RK45 with events, rtol 1e-9) gives these.
  EXPECT_NEAR(stroke_volume, 102.8858, 1e-3);
  EXPECT_NEAR(highest, 127.1004, 1e-2);
  EXPECT_NEAR(lowest, 80.8841, 1e-2);
  EXPECT_NEAR(peak_flow, 841.63, 0.5);
  EXPECT_NEAR(mean, (0.033 + 0.79) * stroke_volume / T, 1e-4 * mean);
}

}  // namespace valsalva::lumped::testing
