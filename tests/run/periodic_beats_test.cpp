// When beats count as repeating.
#include "run/beats/periodic_beats.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace valsalva::run {

namespace {

BeatMetrics beat(int number, double stroke, double systolic, double period = 0.8)
{
  BeatMetrics m;
  m.beat = number;
  m.period_s = period;
  m.stroke_volume_ml = stroke;
  m.p_ao_systolic_mmHg = systolic;
  m.p_ao_mean_mmHg = 95;
  m.p_ao_diastolic_mmHg = 80;
  return m;
}

TEST(PeriodicBeats, StopsAfterTheFirstBeatOfWhichNothingChangedByMore)
{
  PeriodicBeats beats(0.01, 0.8);
  beats.add(beat(1, 70.0, 120.0));
  EXPECT_FALSE(beats.reached());
  EXPECT_NE(beats.add(beat(2, 70.5, 123.0)).find("change from beat 1: 2.4 % (systolic"), std::string::npos);
  EXPECT_FALSE(beats.reached());
  beats.add(beat(3, 72.0, 123.1));  // 2 % of stroke volume
  EXPECT_FALSE(beats.reached());
  beats.add(beat(4, 72.5, 123.0));
  EXPECT_TRUE(beats.reached());
  EXPECT_EQ(beats.outcome(), "periodic after 4 beats");
}

TEST(PeriodicBeats, NeitherAShortenedBeatNorAGapCountsAsTheNext)
{
  PeriodicBeats beats(0.01, 0.8);
  beats.add(beat(1, 70.0, 120.0));
  beats.add(beat(2, 70.0, 120.0, 0.5));
  EXPECT_FALSE(beats.reached());
  beats.add(beat(3, 70.0, 120.0));
  EXPECT_FALSE(beats.reached());
  beats.add(beat(4, 70.0, 120.0));
  EXPECT_TRUE(beats.reached());
}

TEST(PeriodicBeats, ABeatWithoutAStrokeVolumeRepeatsNothing)
{
  PeriodicBeats beats(0.01, 0.8);
  beats.add(beat(1, 70.0, 120.0));
  beats.add(beat(2, std::numeric_limits<double>::quiet_NaN(), 120.0));
  EXPECT_FALSE(beats.reached());
}

TEST(PeriodicBeats, WithoutAToleranceTheRunContinues)
{
  PeriodicBeats beats(0, 0.8);
  for (int n = 1; n < 4; ++n) beats.add(beat(n, 70.0, 120.0));
  EXPECT_FALSE(beats.reached());
}

}  // namespace
}  // namespace valsalva::run
