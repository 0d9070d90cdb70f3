// Periodic states by shooting, against closed forms, marching and central differences.
#include "lumped/integration/limit_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "common/max_or_nan.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

constexpr double kRc = 0.033, kRp = 0.79, kC = 1.75;

NetworkSpec driven_windkessel(ElementSpec source, double period)
{
  return {{std::move(source), windkessel("arteries", "ao", kRc, kRp, kC, 60.0)}, {}, period};
}

/// Largest error of the aortic pressure over the periodic beat as a fraction of its range.
double error_of_range(const NetworkSpec& spec, const std::function<double(double)>& exact)
{
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) times.push_back(spec.period_s * i / 100.0);
  const LimitCycle cycle = find_limit_cycle(spec);
  EXPECT_LE(cycle.newton_steps, 4);
  const SampledBeat beat = sample_beat(spec, cycle, {}, {"p_ao_mmHg"}, times);
  const double range =
      beat.values.maxCoeff<Eigen::PropagateNaN>() - beat.values.minCoeff<Eigen::PropagateNaN>();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < beat.values.rows(); ++i)
    largest = max_or_nan(largest, std::abs(beat.values(i, 0) - exact(times[static_cast<std::size_t>(i)])));
  return largest / range;
}

}  // namespace

TEST(LimitCycle, WindkesselUnderThreeHarmonicsHasItsImpedance)
{
  const double T = 0.8, mean = 90.0;
  const std::vector<double> a = {60.0, -45.0, 12.0}, b = {110.0, 20.0, -30.0};
  ElementSpec source{"heart",
                     "flow_source",
                     {{"node", "ao"}},
                     {},
                     {{"flow_ml_s", {mean}}, {"cosine_ml_s", a}, {"sine_ml_s", b}},
                     {}};
  const auto exact = [&](double t) {
    double p = mean * (kRc + kRp);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const double w = 2.0 * std::numbers::pi * static_cast<double>(k + 1) / T;
      const std::complex<double> Z = kRc + kRp / (1.0 + std::complex<double>(0.0, w * kRp * kC));
      p += (Z * std::complex<double>(a[k], -b[k]) * std::polar(1.0, w * t)).real();
    }
    return p;
  };
  EXPECT_LT(error_of_range(driven_windkessel(source, T), exact), 1e-6);
}

TEST(LimitCycle, WindkesselUnderATrapezoidalInflowIsTheClosedForm)
{
  const double T = 0.8, tau = kRp * kC, rise = 0.05, flat = 0.2, Q = 400.0;
  ElementSpec source = flow_table("heart", "ao", {0.0, rise, rise + flat, 2 * rise + flat}, {0.0, Q, Q, 0.0});
  source.words["beyond_table"] = "repeat";
  const auto inflow = [&](double t) {
    if (t < rise) return Q * t / rise;
    if (t < rise + flat) return Q;
    return t < 2 * rise + flat ? Q * (2 * rise + flat - t) / rise : 0.0;
  };
  // Over a linear piece of length s, Q = q + m s: Pc -> exact exponential.
  const auto pass = [&](double Pc, double q, double m, double s) {
    const auto particular = [&](double x) { return kRp * (q + m * (x - tau)); };
    return particular(s) + (Pc - particular(0.0)) * std::exp(-s / tau);
  };
  const auto Pc_at = [&](double Pc, double t) {
    Pc = pass(Pc, 0.0, Q / rise, std::min(t, rise));
    if (t > rise) Pc = pass(Pc, Q, 0.0, std::min(t - rise, flat));
    if (t > rise + flat) Pc = pass(Pc, Q, -Q / rise, std::min(t - rise - flat, rise));
    if (t > 2 * rise + flat) Pc = pass(Pc, 0.0, 0.0, t - 2 * rise - flat);
    return Pc;
  };
  const double start = Pc_at(0.0, T) / (1.0 - std::exp(-T / tau));
  EXPECT_LT(error_of_range(driven_windkessel(source, T),
                           [&](double t) { return Pc_at(start, t) + kRc * inflow(t); }),
            1e-6);
}

TEST(LimitCycle, WindkesselUnderAHalfSineInflowIsTheClosedForm)
{
  const double T = 0.8, tau = kRp * kC, ejection = 0.3, Q = 450.0, w = std::numbers::pi / ejection;
  std::vector<double> t, q;
  for (int i = 0; i <= 3000; ++i) {  // the chords of the sine are 1e-7 of its peak off
    t.push_back(ejection * i / 3000.0);
    q.push_back(i == 3000 ? 0.0 : Q * std::sin(w * t.back()));
  }
  ElementSpec source = flow_table("heart", "ao", t, q);
  source.words["beyond_table"] = "repeat";
  const double factor = kRp * Q / (1.0 + w * w * tau * tau);
  const auto particular = [&](double x) { return factor * (std::sin(w * x) - w * tau * std::cos(w * x)); };
  const auto Pc_at = [&](double Pc, double x) {
    const double s = std::min(x, ejection);
    Pc = particular(s) + (Pc - particular(0.0)) * std::exp(-s / tau);
    return x > ejection ? Pc * std::exp(-(x - ejection) / tau) : Pc;
  };
  const double start = Pc_at(0.0, T) / (1.0 - std::exp(-T / tau));
  EXPECT_LT(error_of_range(
                driven_windkessel(source, T),
                [&](double x) { return Pc_at(start, x) + (x < ejection ? kRc * Q * std::sin(w * x) : 0.0); }),
            1e-6);
}

TEST(LimitCycle, MeanPressureIsResistanceTimesStrokeVolumePerPeriod)
{
  const NetworkSpec spec = left_heart();
  LimitCycleOptions options;
  options.rtol = 1e-10;
  const LimitCycle cycle = find_limit_cycle(spec, {}, options);
  EXPECT_LE(cycle.newton_steps, 4);
  const SampledBeat beat = sample_beat(spec, cycle, {}, {"p_ao_mmHg", "Q_aortic_ml_s"}, {}, 1e-10);
  const double mean = beat.integrals[0] / 0.8, stroke_volume = beat.integrals[1];
  EXPECT_NEAR(mean / ((0.033 + 0.79) * stroke_volume / 0.8), 1.0, 1e-8);
}

TEST(LimitCycle, ShootingAgreesWithFiftyBeatsOfMarching)
{
  for (const NetworkSpec& spec : {left_heart(), four_chambers()}) {
    const LumpedNetwork network(spec);
    CvodeIntegrator integrator(network, 1e-10);
    LumpedState marched = network.initial_state();
    integrator.advance(marched, 50 * spec.period_s, {}, {});
    LimitCycleOptions options;
    options.rtol = 1e-10;
    const LimitCycle cycle = find_limit_cycle(spec, {}, options);
    EXPECT_LE(cycle.newton_steps, 4);
    for (std::size_t i = 0; i < marched.y.size(); ++i)
      EXPECT_NEAR(cycle.start.y[i], marched.y[i], 2e-6 * (1.0 + std::abs(marched.y[i])))
          << network.states()[i].name;
  }
}

TEST(LimitCycle, AClosedLoopKeepsItsVolume)
{
  const NetworkSpec spec = four_chambers();
  const LumpedNetwork network(spec);
  ASSERT_TRUE(network.keeps_volume());
  const double volume = network.volume(network.initial_state());
  CvodeIntegrator integrator(network);
  LumpedState state = network.initial_state();
  for (int beat = 1; beat <= 5; ++beat) {
    integrator.advance(state, beat * spec.period_s, {}, {});
    EXPECT_NEAR(network.volume(state), volume, 1e-9 * volume);
  }
  const LimitCycle cycle = find_limit_cycle(spec);
  EXPECT_LE(cycle.newton_steps, 4);
  EXPECT_NEAR(network.volume(cycle.start), volume, 1e-8 * volume);
  const Eigen::VectorXcd multipliers = cycle.monodromy.eigenvalues();
  double nearest_one = 1.0;
  for (Eigen::Index i = 0; i < multipliers.size(); ++i)
    nearest_one = min_or_nan(nearest_one, std::abs(multipliers[i] - 1.0));
  EXPECT_LT(nearest_one, 1e-6);
}

}  // namespace valsalva::lumped::testing
