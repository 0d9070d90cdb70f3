// Volume and energy of networks: what came in, minus what was lost, is what is in them now.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lumped/specs.hpp"

namespace valsalva::lumped {
namespace {

using namespace testing;

struct Span {
  Balance begin, end;
  double volume_left() const { return end.volume - begin.volume - (end.inflow - begin.inflow); }
  double work() const { return end.work - begin.work; }
  double loss() const { return end.loss - begin.loss; }
  double energy_left() const { return end.energy - begin.energy - work() + loss(); }
};

/// From t_begin to t_end in pieces of 1 ms, as runs do.
Span balance_between(NetworkSpec spec, double t_begin, double t_end)
{
  spec.balance = true;
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  const auto march = [&](double until) {
    while (state.t < until - 1e-9) integrator.advance(state, std::min(until, state.t + 1e-3), {}, {});
    return network.balance(state);
  };
  Span span;
  span.begin = march(t_begin);
  span.end = march(t_end);
  return span;
}

void expect_closed(const Span& s)
{
  EXPECT_LT(std::abs(s.volume_left()), 1e-6) << "ml";
  EXPECT_LT(std::abs(s.energy_left()), 1e-7 * s.loss()) << s.work() << " mmHg ml of work, lost " << s.loss();
  EXPECT_GT(s.loss(), 0.0);
}

ElementSpec orifice(const std::string& name, const std::string& from, const std::string& to)
{
  return {name, "orifice_valve", {{"from", from}, {"to", to}}, {{"area_open_cm2", 3.5}}, {}, {}};
}

TEST(Balance, ClosesOverABeatOfALeftHeart)
{
  const Span s = balance_between(left_heart(), 0.8, 1.6);
  expect_closed(s);
  // A stroke of about 100 ml against about 100 mmHg; the mean of p Q is what the Windkessel turns into heat.
  EXPECT_GT(s.work(), 5000);
  EXPECT_LT(s.work(), 20000);
}

TEST(Balance, ClosesOverABeatOfAClosedLoop)
{
  const Span s = balance_between(four_chambers(), 0.8, 1.6);
  expect_closed(s);
  EXPECT_EQ(s.end.inflow, 0.0);
}

TEST(Balance, ClosesWithLeafletsWhoseInertanceChanges)
{
  NetworkSpec spec = left_heart();
  spec.elements[3] = orifice("aortic", "lv", "ao");
  expect_closed(balance_between(spec, 0.0, 1.6));
}

TEST(Balance, ClosesThroughAPressurisedStartAndBesideAnInertance)
{
  ElementSpec arteries = windkessel("arteries", "ao");
  arteries.type = "windkessel4";
  arteries.numbers["L_mmHg_s2_ml"] = 0.005;
  arteries.numbers["distal_pressure_mmHg"] = 5.0;
  arteries.numbers["pressurise_s"] = 0.05;
  expect_closed(balance_between(
      {{flow_table("heart", "ao", {0.0, 0.1, 0.3, 0.8}, {20.0, 400.0, 0.0, 0.0}), arteries}, {}, 0.8}, 0.0,
      0.8));
}

TEST(Balance, ClosesWithAFlowSourceAndAStenosis)
{
  ElementSpec stenosis = vessel("stenosis", "in", "out", 0.02, 0.001, 0.5, 60.0);
  stenosis.numbers["S_mmHg_s2_ml2"] = 2e-4;
  expect_closed(balance_between({{flow_table("heart", "in", {0.0, 0.1, 0.3, 0.8}, {0.0, 300.0, 0.0, 0.0}),
                                  stenosis, windkessel("arteries", "out")},
                                 {},
                                 0.8},
                                0.0, 1.2));
}

TEST(Balance, OfAResistorBetweenTwoPressuresIsOhmsLaw)
{
  // 100 mmHg to 20 mmHg through 0.5 mmHg s/ml: 160 ml/s, 12800 mmHg ml/s.
  const Span s = balance_between({{pressure_source("high", "a", 100.0), pressure_source("low", "b", 20.0),
                                   vessel("between", "a", "b", 0.5)},
                                  {},
                                  0.0},
                                 0.0, 0.25);
  EXPECT_NEAR(s.work(), 3200.0, 1e-6);
  EXPECT_NEAR(s.loss(), 3200.0, 1e-6);
  EXPECT_NEAR(s.end.inflow, 0.0, 1e-9);
  EXPECT_EQ(s.end.energy, 0.0);
}

TEST(Balance, EnergyIsThatOfComplianceAndInertance)
{
  NetworkSpec spec{{pressure_source("source", "a", 100.0), vessel("tube", "a", "b", 0.5, 0.01, 2.0, 100.0),
                    pressure_source("end", "b", 40.0)},
                   {},
                   0.0};
  spec.elements[0] = flow_table("source", "a", {0.0, 1.0}, {0.0, 0.0});
  spec.balance = true;
  const LumpedNetwork network(spec);
  LumpedState state = network.initial_state();
  state.y[0] = 30.0;  // ml/s
  EXPECT_NEAR(network.balance(state).energy, 0.5 * 0.01 * 900 + 0.5 * 2.0 * 1e4, 1e-9);
}

}  // namespace
}  // namespace valsalva::lumped
