// Gradients against central differences: of trajectories through valve events, and of the periodic state.
#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "lumped/integration/limit_cycle.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

constexpr double kRtol = 1e-12;

NetworkSpec moved(NetworkSpec spec, const std::string& name, double factor)
{
  double& value = parameter_of(spec, name);
  value *= factor;
  return spec;
}

/// Largest difference of `gradient` (for p dy/dp) from the fourth-order central difference of f, relative to
/// the largest entry.
template <class F>
double difference(const Eigen::VectorXd& gradient, F&& f, const NetworkSpec& spec, const std::string& name)
{
  const double h = 5e-4;
  const auto slope = [&](double step) -> Eigen::VectorXd {
    return (f(moved(spec, name, 1.0 + step)) - f(moved(spec, name, 1.0 - step))) / (2.0 * step);
  };
  const Eigen::VectorXd numerical = (4.0 * slope(h) - slope(2.0 * h)) / 3.0;
  return (gradient - numerical).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
         (1e-2 + numerical.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

Eigen::VectorXd state_at(const NetworkSpec& spec, double t)
{
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network, kRtol);
  LumpedState state = network.initial_state();
  integrator.advance(state, t, {}, {});
  return Eigen::Map<const Eigen::VectorXd>(state.y.data(), network.state_count());
}

Eigen::VectorXd periodic_state(const NetworkSpec& spec, const LumpedState& guess)
{
  LimitCycleOptions options;
  options.rtol = 1e-10;
  const LimitCycle cycle = find_limit_cycle(spec, {}, options, &guess);
  return Eigen::Map<const Eigen::VectorXd>(cycle.start.y.data(),
                                           static_cast<Eigen::Index>(cycle.start.y.size()));
}

NetworkSpec with_orifices()
{
  NetworkSpec spec = left_heart();
  spec.elements[1] = {"mitral", "orifice_valve", {{"from", "la"}, {"to", "lv"}}, {{"area_open_cm2", 5.0}}, {},
                      {}};
  spec.elements[3] = {"aortic", "orifice_valve", {{"from", "lv"}, {"to", "ao"}}, {{"area_open_cm2", 3.0}}, {},
                      {}};
  return spec;
}

const std::vector<std::string> kHeartParameters = {
    "arteries.Rp_mmHg_s_ml",  "arteries.C_ml_mmHg",     "arteries.initial_pressure_mmHg",
    "ventricle.Emax_mmHg_ml", "ventricle.tau1_periods", "ventricle.n2",
    "ventricle.V0_ml",        "veins.pressure_mmHg",    "ventricle.initial_volume_ml"};

NetworkSpec with_root()
{
  NetworkSpec spec = with_orifices();
  spec.elements[3].numbers["L_mmHg_s2_ml"] = 0.0027;
  return spec;
}

}  // namespace

TEST(Sensitivities, FollowTheTrajectoryThroughValveEvents)
{
  NetworkSpec resistive = left_heart();
  resistive.elements[3].numbers["L_mmHg_s2_ml"] = 0.0;
  NetworkSpec bernoulli = left_heart();
  bernoulli.elements[3].numbers["B_mmHg_s2_ml2"] = 2e-5;
  for (const NetworkSpec& spec : {left_heart(), resistive, bernoulli, with_orifices(), with_root()}) {
    const LumpedNetwork network(spec);
    Tangents tangents(spec, kHeartParameters);
    CvodeIntegrator integrator(network, tangents, kRtol);
    LumpedState state = network.initial_state();
    Eigen::MatrixXd S = tangents.initial();
    for (double t : {0.3, 1.2}) {
      integrator.advance(state, S, t);
      for (std::size_t k = 0; k < kHeartParameters.size(); ++k) {
        const Eigen::VectorXd gradient = tangents.scales()[k] * S.col(static_cast<Eigen::Index>(k));
        EXPECT_LT(
            difference(
                gradient, [&](const NetworkSpec& s) { return state_at(s, t); }, spec, kHeartParameters[k]),
            1e-5)
            << kHeartParameters[k] << " at " << t << " s";
      }
    }
  }
}

TEST(Sensitivities, ToAnInitialStateAreThoseToItsInitialValue)
{
  const NetworkSpec spec = left_heart();
  const LumpedNetwork network(spec);
  Tangents tangents(spec, {"arteries.initial_pressure_mmHg", "arteries.Pc_mmHg", "ventricle.V_ml",
                           "ventricle.initial_volume_ml"});
  CvodeIntegrator integrator(network, tangents);
  LumpedState state = network.initial_state();
  Eigen::MatrixXd S = tangents.initial();
  integrator.advance(state, S, 1.0);
  EXPECT_LT((S.col(0) - S.col(1)).norm(), 1e-9);
  EXPECT_LT((S.col(2) - S.col(3)).norm(), 1e-9);
  EXPECT_GT(S.col(2).norm(), 1e-2);
}

TEST(Sensitivities, AtAKinkThatMovesWithAParameterTheyJump)
{
  // The compliance is held until pressurise_s = tau, then charged by Q: Pc = Pe + (P0 - Pe) e^{-(t-tau)/RC}.
  const double Rp = 0.8, C = 1.5, P0 = 70.0, Q = 120.0, tau = 0.1, t = 0.5;
  NetworkSpec spec{
      {flow_table("heart", "ao", {0.0, 2.0}, {Q, Q}), windkessel("arteries", "ao", 0.03, Rp, C, P0)},
      {},
      0.0};
  spec.elements[1].numbers["pressurise_s"] = tau;
  const LumpedNetwork network(spec);
  Tangents tangents(spec, {"arteries.pressurise_s"});
  CvodeIntegrator integrator(network, tangents);
  LumpedState state = network.initial_state();
  Eigen::MatrixXd S = tangents.initial();
  integrator.advance(state, S, t);
  const double e = std::exp(-(t - tau) / (Rp * C));
  EXPECT_NEAR(state.y[0], Rp * Q + (P0 - Rp * Q) * e, 1e-6);
  EXPECT_NEAR(S(0, 0), (P0 - Rp * Q) * e / (Rp * C), 1e-6);
}

TEST(Sensitivities, OfThePeriodicStateAgreeWithDifferencesOfPeriodicStates)
{
  const std::vector<std::string> heart = {"arteries.Rc_mmHg_s_ml", "arteries.Rp_mmHg_s_ml",
                                          "arteries.C_ml_mmHg",    "ventricle.Emax_mmHg_ml",
                                          "veins.pressure_mmHg",   "aortic.L_mmHg_s2_ml"};
  const std::vector<std::string> loop = {"body.R_mmHg_s_ml",    "veins.C_ml_mmHg",
                                         "lv.Emax_mmHg_ml",     "lungs.C_ml_mmHg",
                                         "la.onset_periods",    "veins.initial_pressure_mmHg",
                                         "lv.initial_volume_ml"};
  const auto check = [](const NetworkSpec& spec, const std::vector<std::string>& names) {
    LimitCycleOptions options;
    options.rtol = 1e-10;
    const LimitCycle cycle = find_limit_cycle(spec, names, options);
    const Tangents tangents(spec, names);
    for (std::size_t k = 0; k < names.size(); ++k)
      EXPECT_LT(difference(
                    tangents.scales()[k] * cycle.S.col(static_cast<Eigen::Index>(k)),
                    [&](const NetworkSpec& s) { return periodic_state(s, cycle.start); }, spec, names[k]),
                1e-5)
          << names[k];
  };
  check(left_heart(), heart);
  check(four_chambers(), loop);
}

TEST(Sensitivities, OfPeriodicOutputsObeyTheMeanPressureIdentity)
{
  const NetworkSpec spec = left_heart();
  const std::vector<std::string> names = {"arteries.Rp_mmHg_s_ml", "ventricle.Emax_mmHg_ml"};
  LimitCycleOptions options;
  options.rtol = 1e-10;
  const LimitCycle cycle = find_limit_cycle(spec, names, options);
  const SampledBeat beat = sample_beat(spec, cycle, names, {"p_ao_mmHg", "Q_aortic_ml_s"}, {}, 1e-10);
  const double SV = beat.integrals[1], R = 0.033 + 0.79;
  const Eigen::RowVectorXd dP = beat.integral_gradients.row(0), dV = beat.integral_gradients.row(1);
  EXPECT_NEAR(dP[0], SV + R * dV[0], 1e-6 * std::abs(dP[0]));
  EXPECT_NEAR(dP[1], R * dV[1], 1e-6 * std::abs(dP[1]));
  EXPECT_LT(dV[0], 0.0);
  EXPECT_GT(dV[1], 0.0);
}

TEST(Sensitivities, AnUnknownDirectionIsNamedWithTheNearest)
{
  try {
    const Tangents tangents(left_heart(), {"arteries.Rp_mmHg_s_m"});
    FAIL() << "accepted";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'arteries.Rp_mmHg_s_ml'"), std::string::npos)
        << error.what();
  }
}

}  // namespace valsalva::lumped::testing
