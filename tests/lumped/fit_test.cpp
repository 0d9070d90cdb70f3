// Fits of synthetic data whose truth is known: recovery, standard deviations, and what cannot be identified.
#include "lumped/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/error.hpp"
#include "lumped/integration/limit_cycle.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

const std::vector<std::string> kWindkessel = {"arteries.Rc_mmHg_s_ml", "arteries.Rp_mmHg_s_ml",
                                              "arteries.C_ml_mmHg"};

NetworkSpec driven(double Rc, double Rp, double C)
{
  return {
      {{"heart",
        "flow_source",
        {{"node", "ao"}},
        {},
        {{"flow_ml_s", {95.0}}, {"cosine_ml_s", {40.0, -80.0, -20.0}}, {"sine_ml_s", {150.0, 60.0, -25.0}}},
        {}},
       windkessel("arteries", "ao", Rc, Rp, C, 80.0)},
      {},
      0.8};
}

std::vector<double> sample_times(double period, int count)
{
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(period * i / count);
  return times;
}

std::vector<double> periodic_trace(const NetworkSpec& spec, const std::string& observable,
                                   const std::vector<double>& times)
{
  LimitCycleOptions options;
  options.rtol = 1e-11;
  const SampledBeat beat =
      sample_beat(spec, find_limit_cycle(spec, {}, options), {}, {observable}, times, 1e-11);
  return {beat.values.data(), beat.values.data() + beat.values.rows()};
}

/// Three elements to the pressure of `truth`, from a start far away.
FitProblem windkessel_problem(const NetworkSpec& truth)
{
  FitProblem problem;
  problem.network = driven(0.06, 1.2, 1.0);
  for (const std::string& name : kWindkessel) problem.parameters.push_back({name});
  const std::vector<double> times = sample_times(0.8, 160);
  problem.signals.push_back({"pressure", "p_ao_mmHg", times, periodic_trace(truth, "p_ao_mmHg", times)});
  return problem;
}

bool is_flagged(const Fit& result, const std::vector<std::string>& parts)
{
  for (const std::string& flag : result.flags) {
    bool all = true;
    for (const std::string& part : parts) all = all && flag.find(part) != std::string::npos;
    if (all) return true;
  }
  return false;
}

}  // namespace

TEST(Fit, RecoversAWindkesselFromExactData)
{
  const Fit result = fit(windkessel_problem(driven(0.033, 0.79, 1.75)));
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.estimates[0].value / 0.033, 1.0, 1e-6);
  EXPECT_NEAR(result.estimates[1].value / 0.79, 1.0, 1e-6);
  EXPECT_NEAR(result.estimates[2].value / 1.75, 1.0, 1e-6);
  EXPECT_EQ(result.rank, 3);
  EXPECT_TRUE(result.flags.empty()) << result.flags.front();
}

TEST(Fit, RecoversVentricleAndArteriesThroughValveEvents)
{
  const NetworkSpec truth = left_heart();
  FitProblem problem;
  problem.network = truth;
  problem.network.elements[2].numbers["Emax_mmHg_ml"] = 2.0;
  problem.network.elements[4].numbers["Rp_mmHg_s_ml"] = 1.0;
  problem.network.elements[4].numbers["C_ml_mmHg"] = 1.4;
  problem.network.elements[4].numbers["Rc_mmHg_s_ml"] = 0.04;
  for (const std::string& name : kWindkessel) problem.parameters.push_back({name});
  problem.parameters.push_back({"ventricle.Emax_mmHg_ml", 0.5, 5.0});
  const std::vector<double> times = sample_times(0.8, 80);
  problem.signals.push_back({"p", "p_ao_mmHg", times, periodic_trace(truth, "p_ao_mmHg", times), 1.0});
  problem.signals.push_back(
      {"Q", "Q_aortic_ml_s", times, periodic_trace(truth, "Q_aortic_ml_s", times), 5.0});
  const Fit result = fit(problem);
  const double exact[] = {0.033, 0.79, 1.75, 2.4};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(result.estimates[k].value / exact[k], 1.0, 1e-6);
}

TEST(Fit, FindsBaselineAndTimeShift)
{
  const NetworkSpec truth = driven(0.033, 0.79, 1.75);
  FitProblem problem = windkessel_problem(truth);
  FitSignal& signal = problem.signals.front();
  std::vector<double> moved;
  for (double t : signal.t) moved.push_back(std::fmod(t + 0.013, 0.8));
  std::vector<double> order = moved;
  std::sort(order.begin(), order.end());
  const std::vector<double> values = periodic_trace(truth, "p_ao_mmHg", order);
  for (std::size_t i = 0; i < moved.size(); ++i)
    signal.value[i] =
        values[static_cast<std::size_t>(std::find(order.begin(), order.end(), moved[i]) - order.begin())] +
        4.0;
  signal.has_baseline = signal.has_shift = true;
  problem.parameters.erase(problem.parameters.begin() + 1);  // Rp and a constant are one
  problem.network.elements[1].numbers["Rp_mmHg_s_ml"] = 0.79;
  const Fit result = fit(problem);
  EXPECT_NEAR(result.estimates[0].value, 0.033, 1e-6);
  EXPECT_NEAR(result.estimates[1].value, 1.75, 1e-5);
  EXPECT_NEAR(result.estimates[2].value, 4.0, 1e-5);
  EXPECT_NEAR(result.estimates[3].value, 0.013, 1e-7);
}

TEST(Fit, TheSpreadOverAHundredNoisyBeatsIsTheReportedStandardDeviation)
{
  const double exact[] = {0.033, 0.79, 1.75};
  FitProblem problem = windkessel_problem(driven(exact[0], exact[1], exact[2]));
  problem.network = driven(exact[0], exact[1], exact[2]);
  const std::vector<double> clean = problem.signals.front().value;
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 1.0);
  const int seeds = 100;
  double square[3] = {}, reported[3] = {};
  for (int seed = 0; seed < seeds; ++seed) {
    for (std::size_t i = 0; i < clean.size(); ++i)
      problem.signals.front().value[i] = clean[i] + noise(generator);
    const Fit result = fit(problem);
    for (std::size_t k = 0; k < 3; ++k) {
      square[k] += std::pow(result.estimates[k].value - exact[k], 2) / seeds;
      reported[k] += result.estimates[k].sd / seeds;
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(std::sqrt(square[k]) / reported[k], 1.0, 0.15) << kWindkessel[k];
}

TEST(Fit, SummariesAloneDoNotIdentifyTheCharacteristicResistance)
{
  const NetworkSpec truth = driven(0.033, 0.79, 1.75);
  const std::vector<double> p = periodic_trace(truth, "p_ao_mmHg", sample_times(0.8, 800));
  FitProblem problem;
  problem.network = truth;
  for (const std::string& name : kWindkessel) problem.parameters.push_back({name});
  double mean = 0.0;
  for (double value : p) mean += value / 800.0;
  problem.summaries = {
      {"systolic", SummaryKind::systolic, "p_ao_mmHg", *std::max_element(p.begin(), p.end()), 4.0},
      {"diastolic", SummaryKind::diastolic, "p_ao_mmHg", *std::min_element(p.begin(), p.end()), 4.0},
      {"mean", SummaryKind::mean, "p_ao_mmHg", mean, 3.0}};
  const Fit result = fit(problem);
  EXPECT_GT(result.estimates[0].relative_sd, 1.0);
  EXPECT_LT(result.estimates[1].relative_sd, 0.2);
  EXPECT_TRUE(is_flagged(result, {"arteries.Rc_mmHg_s_ml", "not identified"}));
}

TEST(Fit, TwoResistancesInSeriesAreFlaggedAsIndistinguishable)
{
  NetworkSpec truth{{{"heart",
                      "pressure_source",
                      {{"node", "lv"}},
                      {},
                      {{"pressure_mmHg", {90.0}}, {"cosine_mmHg", {-20.0}}, {"sine_mmHg", {15.0}}},
                      {}},
                     vessel("outlet", "lv", "ao", 0.02),
                     windkessel("arteries", "ao", 0.05, 0.79, 1.75, 80.0)},
                    {},
                    0.8};
  FitProblem problem;
  problem.network = truth;
  problem.network.elements[1].numbers["R_mmHg_s_ml"] = 0.03;
  problem.parameters = {{"outlet.R_mmHg_s_ml"}, {"arteries.Rc_mmHg_s_ml"}, {"arteries.C_ml_mmHg"}};
  const std::vector<double> times = sample_times(0.8, 80);
  problem.signals.push_back({"flow", "Q_outlet_ml_s", times, periodic_trace(truth, "Q_outlet_ml_s", times)});
  const Fit result = fit(problem);
  EXPECT_EQ(result.rank, 2);
  EXPECT_TRUE(is_flagged(result, {"outlet.R_mmHg_s_ml and arteries.Rc_mmHg_s_ml", "cannot be told apart"}));
  EXPECT_NEAR(result.estimates[0].value + result.estimates[1].value, 0.07, 1e-6);
  EXPECT_TRUE(std::isinf(result.estimates[0].sd));
  EXPECT_TRUE(std::isfinite(result.estimates[2].sd));
}

TEST(Fit, ABoundThatHoldsIsReported)
{
  FitProblem problem = windkessel_problem(driven(0.033, 0.79, 1.75));
  problem.parameters[2] = {"arteries.C_ml_mmHg", 0.5, 1.5};
  const Fit result = fit(problem);
  EXPECT_NEAR(result.estimates[2].value, 1.5, 1e-9);
  EXPECT_TRUE(is_flagged(result, {"arteries.C_ml_mmHg lies at its bound"}));
}

TEST(Fit, RefusesASourceThatHoldsItsLastValueInAPeriodicBeat)
{
  FitProblem problem = windkessel_problem(driven(0.033, 0.79, 1.75));
  problem.network.elements[0] = flow_table("heart", "ao", {0.0, 0.1, 0.3, 0.79}, {0.0, 300.0, 0.0, 0.0});
  try {
    fit(problem);
    FAIL() << "no CaseError";
  } catch (const CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("use beyond_table = \"repeat\""), std::string::npos);
  }
  problem.network.elements[0].words["beyond_table"] = "repeat";
  EXPECT_NO_THROW(fit(problem));
}

TEST(Fit, FlagsDataOfAnotherLengthThanTheBeat)
{
  FitProblem problem = windkessel_problem(driven(0.033, 0.79, 1.75));
  EXPECT_FALSE(is_flagged(fit(problem), {"time.period_s"}));
  problem.network.period_s = 0.803;  // less than a sample interval of 5 ms away
  EXPECT_FALSE(is_flagged(fit(problem), {"time.period_s"}));
  problem.network.period_s = 0.83;
  EXPECT_TRUE(is_flagged(fit(problem), {"data of pressure cover 0.8 s", "time.period_s = 0.83 s"}));
}

}  // namespace valsalva::lumped::testing
