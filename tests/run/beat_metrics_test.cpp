// Metrics of a beat made of known pieces: half-sine ejection, half-sine closing lobe, constant leak.
#include "run/beats/beat_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace valsalva::run {

using namespace coupling;
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOpen = 0.10, kFall = 0.40, kShut = 0.44, kEnd = 0.80;
constexpr double kPeak = 450, kLobe = 60, kLeak = 1.5;

/// Flow through zero at 0.10 (up), 0.40 (down) and 0.44 s (closed); p_lv - p_ao = 6 sin in ejection.
std::vector<BeatSample> beat(double start, double orifice_after_closure = -1)
{
  std::vector<BeatSample> samples;
  for (int n = 0; n <= 8000; ++n) {
    const double t = n * 1e-4;
    BeatSample s;
    s.t_s = start + t;
    s.p_aorta_mmHg = 80;
    s.p_ventricle_mmHg = 10;
    s.orifice_cm2 = orifice_after_closure < 0 ? -1 : orifice_after_closure;
    s.inflow_ml_s = 0.25;
    if (t <= kOpen + 1e-9 || t > kShut + 1e-9)
      s.flow_ml_s = t <= kOpen + 1e-9 ? 0.0 : -kLeak;
    else if (t <= kFall + 1e-9) {
      const double phase = kPi * (t - kOpen) / (kFall - kOpen);
      s.flow_ml_s = kPeak * std::sin(phase);
      s.p_aorta_mmHg = 80 + 40 * std::sin(phase);
      s.p_ventricle_mmHg = s.p_aorta_mmHg + 6 * std::sin(phase);
      if (orifice_after_closure >= 0) s.orifice_cm2 = 3.0;
    } else {
      s.flow_ml_s = -kLobe * std::sin(kPi * (t - kFall) / (kShut - kFall));
      if (orifice_after_closure >= 0) s.orifice_cm2 = 3.0 * (kShut - t) / (kShut - kFall);
    }
    samples.push_back(s);
  }
  return samples;
}

TEST(BeatMetrics, VolumesOfEjectionClosingAndLeakAreTheIntegrals)
{
  // The leak follows the closing lobe without a break in sign: the orifice tells where one ends.
  const BeatMetrics m = measure_beat(3, beat(1.6, 0.0));
  EXPECT_EQ(m.beat, 3);
  EXPECT_NEAR(m.start_s, 1.6, 1e-12);
  EXPECT_NEAR(m.period_s, kEnd, 1e-9);
  EXPECT_NEAR(m.forward_volume_ml, kPeak * 2 / kPi * (kFall - kOpen), 1e-3);
  // Shut counts from 0.05 cm^2: 1/60 of the lobe's time before its end.
  EXPECT_NEAR(m.closing_volume_ml, kLobe * 2 / kPi * (kShut - kFall), 0.02);
  EXPECT_NEAR(m.leak_volume_ml, kLeak * (kEnd - kShut), 0.02);
  EXPECT_NEAR(m.mean_leak_ml_s, kLeak, 0.05);
  EXPECT_NEAR(m.stroke_volume_ml, m.forward_volume_ml - m.closing_volume_ml - m.leak_volume_ml, 1e-12);
}

TEST(BeatMetrics, AFlowThatHoversAboutZeroBeforeTheBackflowDoesNotEndTheClosing)
{
  // A small wave, back and forth, between ejection and closing lobe; its integral is zero.
  constexpr double kWave = 0.02;
  std::vector<BeatSample> samples;
  for (BeatSample s : beat(0, 0.0)) {
    if (s.t_s > kFall + 1e-9) s.t_s += kWave;
    samples.push_back(s);
    if (std::abs(s.t_s - kFall) > 1e-9) continue;
    for (int n = 1; n < 200; ++n) {
      s.t_s = kFall + kWave * n / 200;
      s.flow_ml_s = -5 * std::sin(2 * kPi * n / 200);
      samples.push_back(s);
    }
  }
  EXPECT_NEAR(measure_beat(1, samples).closing_volume_ml, kLobe * 2 / kPi * (kShut - kFall), 0.05);
}

TEST(BeatMetrics, TimesPressuresAndBalanceAreThoseOfTheCurves)
{
  const BeatMetrics m = measure_beat(1, beat(0.0, 0.0));
  EXPECT_NEAR(m.ejection_time_s, kFall - kOpen, 2.1e-4);
  EXPECT_NEAR(m.opening_s, kOpen, 1.1e-4);
  EXPECT_NEAR(m.closing_s, kShut, 1e-3);
  EXPECT_NEAR(m.peak_flow_ml_s, kPeak, 1e-3);
  EXPECT_NEAR(m.least_flow_ml_s, -kLobe, 1e-3);
  EXPECT_NEAR(m.mean_gradient_mmHg, 6 * 2 / kPi, 0.02);
  EXPECT_NEAR(m.max_orifice_area_cm2, 3.0, 1e-12);
  EXPECT_NEAR(m.p_ao_systolic_mmHg, 120, 1e-3);
  EXPECT_NEAR(m.p_ao_diastolic_mmHg, 80, 1e-3);
  EXPECT_NEAR(m.p_ao_mean_mmHg, 80 + 40 * 2 / kPi * (kFall - kOpen) / kEnd, 0.01);
  EXPECT_NEAR(m.mass_balance_ml, 0.25 * kEnd, 1e-9);
}

TEST(BeatMetrics, WithoutAnOrificeTheClosingEndsWhereTheFlowReturnsToZero)
{
  std::vector<BeatSample> samples = beat(0.0);
  for (BeatSample& s : samples)
    if (s.t_s > kShut + 1e-9) s.flow_ml_s = s.t_s < 0.5 ? 0.5 : -kLeak;  // a small rebound
  const BeatMetrics m = measure_beat(1, samples);
  EXPECT_NEAR(m.closing_volume_ml, kLobe * 2 / kPi * (kShut - kFall), 2e-3);
  EXPECT_NEAR(m.leak_volume_ml, kLeak * (kEnd - 0.5) - 0.5 * (0.5 - kShut), 2e-3);
}

TEST(BeatMetrics, BeatWithoutEjectionHasNoVolumes)
{
  std::vector<BeatSample> samples = beat(0.0);
  for (BeatSample& s : samples) s.flow_ml_s = -kLeak;
  const BeatMetrics m = measure_beat(1, samples);
  EXPECT_EQ(m.forward_volume_ml, 0);
  EXPECT_EQ(m.ejection_time_s, 0);
  EXPECT_GT(m.p_ao_mean_mmHg, 80);
  EXPECT_EQ(measure_beat(1, {}).stroke_volume_ml, 0);
}

TEST(BeatMetrics, RowHasAValueForEveryColumn)
{
  EXPECT_EQ(beat_columns().size(), beat_row({}).size());
}

}  // namespace
}  // namespace valsalva::run
