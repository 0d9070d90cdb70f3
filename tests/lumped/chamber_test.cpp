#include "lumped/elements/chamber.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/max_or_nan.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

TEST(Chamber, IsovolumicPressureIsElastanceTimesStressedVolume)
{
  ElementSpec ventricle = chamber("ventricle", "lv");
  ventricle.words["activation"] = "half_cosine";
  ventricle.numbers["systole_periods"] = 0.5;
  const LumpedNetwork network({{ventricle}, {"lv"}, 0.0});
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  const std::vector<double> none = {0.0};
  for (double t : {0.1, 0.2, 0.35, 0.6, 0.9, 1.3}) {
    integrator.advance(state, t, none, none);
    const double s = std::fmod(t, 0.8);
    const double e = s < 0.4 ? 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * s / 0.4)) : 0.0;
    EXPECT_EQ(state.y[0], 130.0);
    EXPECT_NEAR(integrator.port_pressures(state, none)[0], (0.065 + (2.4 - 0.065) * e) * (130.0 - 12.0),
                1e-9);
  }
}

TEST(Chamber, DoubleHillReachesOneOnceAndHasItsShape)
{
  const DoubleHill shape = {1.32, 21.9, 0.303 * 0.8, 0.508 * 0.8};
  const Activation<double> activation = Activation<double>::double_hill(shape, 0.8);
  const auto unscaled = [&](double t) {
    const double h1 = std::pow(t / shape.tau1_s, shape.n1), h2 = std::pow(t / shape.tau2_s, shape.n2);
    return h1 / (1.0 + h1) / (1.0 + h2);
  };
  double largest = 0.0;
  for (int i = 1; i <= 80000; ++i) largest = max_or_nan(largest, activation.value(1e-5 * i));
  EXPECT_NEAR(largest, 1.0, 1e-7);
  EXPECT_LE(largest, 1.0 + 1e-12);
  EXPECT_NEAR(activation.value(0.2) / activation.value(0.45), unscaled(0.2) / unscaled(0.45), 1e-12);
  EXPECT_EQ(activation.value(0.0), 0.0);
}

TEST(Chamber, SourceResistanceAddsToThePressure)
{
  ElementSpec ventricle = chamber("ventricle", "lv");
  ventricle.numbers["R_mmHg_s_ml"] = 0.02;
  const LumpedNetwork with({{ventricle}, {"lv"}, 0.0}), without({{chamber("ventricle", "lv")}, {"lv"}, 0.0});
  LumpedState state = with.initial_state();
  state.t = 0.3;
  const std::vector<double> Q = {-300.0};
  EXPECT_NEAR(with.port_pressures(state, Q)[0], without.port_pressures(state, Q)[0] - 6.0, 1e-9);
}

TEST(Chamber, VolumesChangeByExactlyTheInflow)
{
  const LumpedNetwork network({{chamber("left", "a", 120.0), valve("v", "a", "b", 0.01, 0.0004, 1e-5),
                                valve("w", "b", "a", 0.008), chamber("right", "b", 60.0)},
                               {"b"},
                               0.0});
  CvodeIntegrator integrator(network, 1e-10);
  LumpedState state = network.initial_state();
  double inflow = 0.0;
  for (int i = 0; i < 160; ++i) {
    const double Q0 = 20.0 * std::sin(0.5 * i), Q1 = 20.0 * std::sin(0.5 * (i + 1));
    integrator.advance(state, 0.01 * (i + 1), std::vector{Q0}, std::vector{Q1});
    inflow += 0.01 * 0.5 * (Q0 + Q1);
  }
  double volume = 0.0;
  for (std::size_t i = 0; i < network.states().size(); ++i)
    if (network.states()[i].unit == "ml") volume += state.y[i];
  EXPECT_GT(integrator.statistics().events, 0);
  EXPECT_NEAR(volume - 180.0, inflow, 1e-9 * 180.0);
}

TEST(Chamber, KinksAreTheOnsetsOfContraction)
{
  const LumpedNetwork network({{chamber("ventricle", "lv")}, {}, 0.0});
  EXPECT_DOUBLE_EQ(network.next_kink(0.0), 0.8);
  EXPECT_DOUBLE_EQ(network.next_kink(0.8), 1.6);
  EXPECT_DOUBLE_EQ(network.next_kink(0.8 - 1e-16), 1.6);
  double t = 0.0;
  for (int beat = 1; beat <= 100; ++beat) {
    t = network.next_kink(t);
    EXPECT_NEAR(t, 0.8 * beat, 1e-12);
  }
}

}  // namespace valsalva::lumped::testing
