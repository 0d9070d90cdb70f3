// Vessel, four-element Windkessel, orifice valve, Fourier sources: against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "common/error.hpp"
#include "common/units.hpp"
#include "lumped/integration/limit_cycle.hpp"
#include "lumped/refusal.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

double advance_and_observe(const NetworkSpec& spec, double t, const std::string& name)
{
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  integrator.advance(state, t, {}, {});
  return observed(network, state, name);
}

}  // namespace

TEST(Vessel, StepPressureGivesExponentialFlow)
{
  const double R = 0.05, L = 0.002, dp = 10.0, t = 0.1;
  const double Q = advance_and_observe(
      {{pressure_source("a", "a", dp), vessel("v", "a", "b", R, L), pressure_source("b", "b", 0.0)}, {}, 0.0},
      t, "Q_v_ml_s");
  EXPECT_NEAR(Q, dp / R * (1.0 - std::exp(-R * t / L)), 1e-8 * dp / R);
}

TEST(Vessel, AlongAResistanceTheWallFillsExponentiallyAtEitherEnd)
{
  const double R = 0.5, C = 1.2, t = 0.4;
  ElementSpec outlet = vessel("v", "a", "b", R, 0.0, C, 20.0);
  outlet.words["wall"] = "outlet";
  EXPECT_NEAR(advance_and_observe({{pressure_source("a", "a", 100.0), outlet}, {}, 0.0}, t, "p_b_mmHg"),
              100.0 - 80.0 * std::exp(-t / (R * C)), 1e-7);
  EXPECT_NEAR(advance_and_observe(
                  {{vessel("v", "a", "b", R, 0.0, C, 20.0), pressure_source("b", "b", 100.0)}, {}, 0.0}, t,
                  "p_a_mmHg"),
              100.0 - 80.0 * std::exp(-t / (R * C)), 1e-7);
}

TEST(Vessel, WithInertanceAndWallItOscillates)
{
  const double L = 0.01, C = 1.0, R = 0.02, P = 10.0, t = 0.7;
  ElementSpec v = vessel("v", "a", "b", R, L, C, 0.0);
  v.words["wall"] = "outlet";
  const double damping = R / (2.0 * L), w = std::sqrt(1.0 / (L * C) - damping * damping);
  EXPECT_NEAR(advance_and_observe({{pressure_source("a", "a", P), v}, {}, 0.0}, t, "p_b_mmHg"),
              P * (1.0 - std::exp(-damping * t) * (std::cos(w * t) + damping / w * std::sin(w * t))), 1e-7);
}

TEST(Vessel, AStenosisTakesTheQuadraticShare)
{
  const double R = 0.02, S = 1e-4, dp = 30.0;
  const double exact = (-R + std::sqrt(R * R + 4.0 * S * dp)) / (2.0 * S);
  for (double L : {0.0, 0.0005}) {
    ElementSpec v = vessel("v", "a", "b", R, L);
    v.numbers["S_mmHg_s2_ml2"] = S;
    EXPECT_NEAR(
        advance_and_observe({{pressure_source("a", "a", dp), v, pressure_source("b", "b", 0.0)}, {}, 0.0},
                            2.0, "Q_v_ml_s"),
        exact, 1e-7 * exact);
  }
}

TEST(Windkessel4, HasTheImpedanceOfItsFourElements)
{
  const double T = 0.83, Rc = 0.056, Rp = 0.79, C = 1.22, L = 0.0051, a = 150.0, b = 90.0;
  ElementSpec arteries = windkessel("arteries", "ao", Rc, Rp, C, 80.0);
  arteries.type = "windkessel4";
  arteries.numbers["L_mmHg_s2_ml"] = L;
  const NetworkSpec spec{{{"heart",
                           "flow_source",
                           {{"node", "ao"}},
                           {},
                           {{"flow_ml_s", {100.0}}, {"cosine_ml_s", {0.0, a}}, {"sine_ml_s", {0.0, b}}},
                           {}},
                          arteries},
                         {},
                         T};
  const LimitCycle cycle = find_limit_cycle(spec);
  EXPECT_LE(cycle.newton_steps, 4);
  const std::vector<double> times = {0.0, 0.1, 0.33, 0.6};
  const SampledBeat beat = sample_beat(spec, cycle, {}, {"p_ao_mmHg"}, times);
  // At steady flow the inertance is a short circuit: the mean sees Rp alone.
  const std::complex<double> i(0.0, 1.0);
  const double w = 2.0 * 2.0 * std::numbers::pi / T;
  const std::complex<double> Z = i * w * L * Rc / (Rc + i * w * L) + Rp / (1.0 + i * w * Rp * C);
  for (std::size_t n = 0; n < times.size(); ++n)
    EXPECT_NEAR(beat.values(static_cast<Eigen::Index>(n), 0),
                100.0 * Rp + (Z * std::complex<double>(a, -b) * std::polar(1.0, w * times[n])).real(), 1e-5);
}

TEST(OrificeValve, WideOpenItHasTheBernoulliFlow)
{
  const double area = 2.0, dp = 8.0, rho = 1.06;
  const NetworkSpec spec{
      {pressure_source("a", "a", dp),
       {"v", "orifice_valve", {{"from", "a"}, {"to", "b"}}, {{"area_open_cm2", area}}, {}, {}},
       pressure_source("b", "b", 0.0)},
      {},
      0.0};
  const double exact = area * std::sqrt(2.0 * common::dyn_cm2_from_mmHg(dp) / rho);
  EXPECT_NEAR(advance_and_observe(spec, 1.0, "Q_v_ml_s"), exact, 1e-6 * exact);
}

TEST(OrificeValve, ItsLeafletsOpenAndCloseByTheirRates)
{
  // The drop is +5 mmHg for 0.05 s, then -3: zeta = 1 - exp(-K dp t), then decays by exp(-K |dp| t).
  const double K_open = 12.0, K_close = 30.0;
  ElementSpec v{"v",
                "orifice_valve",
                {{"from", "a"}, {"to", "b"}},
                {{"area_open_cm2", 3.0}, {"opening_1_mmHg_s", K_open}, {"closing_1_mmHg_s", K_close}},
                {},
                {}};
  const LumpedNetwork network(
      {{pressure_table("a", "a", {0.0, 0.05, 0.05 + 1e-9, 1.0}, {5.0, 5.0, -3.0, -3.0}), v,
        pressure_source("b", "b", 0.0)},
       {},
       0.0});
  CvodeIntegrator integrator(network, 1e-11);
  LumpedState state = network.initial_state();
  integrator.advance(state, 0.05, {}, {});
  const double opened = 1.0 - std::exp(-K_open * 5.0 * 0.05);
  EXPECT_NEAR(state.y[1], opened, 1e-8);
  EXPECT_GT(state.y[0], 100.0);
  integrator.advance(state, 0.07, {}, {});
  EXPECT_NEAR(state.y[1], opened * std::exp(-K_close * 3.0 * 0.02), 1e-6);
  integrator.advance(state, 1.0, {}, {});
  EXPECT_EQ(state.valve_open[0], 0);
  const double leak = 1e-4 * std::sqrt(2.0 * common::dyn_cm2_from_mmHg(3.0) / 1.06);
  EXPECT_NEAR(state.y[0], -leak, 1e-3 * leak);
}

TEST(OrificeValve, ItsLeafletsDoNotFeelThePressureThatAcceleratesTheVessels)
{
  // At the start Q = 0 and A = A_closed, so that of dp the share Lv/(L + Lv) drops across the leaflets.
  const double dp = 5.0, K = 12.0, L = 3.0, rho = common::mmHg_from_dyn_cm2(1.06), closed = 0.001;
  const double Lv = rho / closed, t = 1e-8;
  for (const double in_series : {0.0, L}) {
    const LumpedNetwork network({{pressure_source("a", "a", dp),
                                  {"v",
                                   "orifice_valve",
                                   {{"from", "a"}, {"to", "b"}},
                                   {{"area_open_cm2", 3.0},
                                    {"area_closed_cm2", closed},
                                    {"opening_1_mmHg_s", K},
                                    {"L_mmHg_s2_ml", in_series}},
                                   {},
                                   {}},
                                  pressure_source("b", "b", 0.0)},
                                 {},
                                 0.0});
    CvodeIntegrator integrator(network, 1e-11);
    LumpedState state = network.initial_state();
    integrator.advance(state, t, {}, {});
    const double share = Lv / (in_series + Lv);
    EXPECT_NEAR(state.y[1], K * dp * share * t, 1e-2 * K * dp * t * share);
    EXPECT_NEAR(state.y[0], dp / (in_series + Lv) * t, 1e-2 * dp / Lv * t);
  }
}

TEST(BadNetwork, AVesselThatIsNothingAndAJunctionWithoutPressureAreNamed)
{
  EXPECT_NE(refusal({{chamber("c", "a"), vessel("v", "a", "b", 0.0), windkessel("w", "b")}, {}, 0.8})
                .find("nothing stands between the nodes \"a\" and \"b\""),
            std::string::npos);
  EXPECT_NE(refusal({{chamber("c", "a"), vessel("v", "a", "m", 0.1), vessel("u", "m", "b", 0.1),
                      windkessel("w", "b")},
                     {},
                     0.8})
                .find("node \"m\": joins only \"v\", \"u\""),
            std::string::npos);
  EXPECT_NE(refusal({{pressure_source("p", "a", 5.0), vessel("v", "a", "b", 0.1, 0.0, 1.0)}, {}, 0.0})
                .find("node \"a\": has its pressure fixed by \"p\", \"v\" at once"),
            std::string::npos);
  ElementSpec series{"s", "flow_source", {{"node", "b"}}, {}, {{"flow_ml_s", {1.0}}, {"sine_ml_s", {2.0}}},
                     {}};
  EXPECT_NE(refusal({{series, windkessel("w", "b")}, {}, 0.0}).find("give time.period_s"), std::string::npos);
  ElementSpec unread{"s", "flow_source", {{"node", "b"}}, {}, {}, {{"column", "Q_ao_ml_s"}}};
  EXPECT_NE(refusal({{unread, windkessel("w", "b")}, {}, 0.8}).find("column \"Q_ao_ml_s\" has not been read"),
            std::string::npos);
}

}  // namespace valsalva::lumped::testing
