// Nothing is lost between one beat's statistics and the next.
#include "run/beats/beat_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace valsalva::run {

using namespace coupling;
namespace {

constexpr double kPeriod = 0.8;

/// A flow into the root about 3 ml/s that does not repeat with the beats.
BeatSample sample_at(double t)
{
  BeatSample s;
  s.t_s = t;
  s.flow_ml_s = 100 * std::sin(2 * std::numbers::pi * t / kPeriod);
  s.inflow_ml_s = 3 + std::sin(5 * t);
  return s;
}

BalanceState totals_at(double t)
{
  BalanceState s;
  s.network.inflow = 7 * t * t;
  s.root_work_mJ = t * t * t;
  return s;
}

TEST(BeatStatistics, BeatsAddUpToTheRunAlsoWhenItEndsWithinOne)
{
  constexpr double kEnd = 2.0, kStep = 1e-3;
  BeatStatistics statistics(kPeriod);
  statistics.add(sample_at(0));
  statistics.begin(totals_at(0));
  EXPECT_FALSE(statistics.has_begun());
  std::vector<BeatMetrics> beats;
  for (int n = 1; n <= 2000; ++n) {
    statistics.add(sample_at(n * kStep));
    if (n * kStep > statistics.end_s() - 1e-9 || n == 2000)
      beats.push_back(statistics.close(totals_at(n * kStep)));
  }
  ASSERT_EQ(beats.size(), 3U);
  EXPECT_FALSE(statistics.has_begun());
  double length = 0, inflow = 0, network = 0, work = 0;
  for (const BeatMetrics& m : beats) {
    EXPECT_EQ(m.beat, &m - beats.data() + 1);
    EXPECT_DOUBLE_EQ(m.start_s, length);
    length += m.period_s;
    inflow += m.mass_balance_ml;
    network += m.balance.network_inflow_ml;
    work += m.balance.root_work_mJ;
  }
  EXPECT_NEAR(beats[1].start_s, kPeriod, 1e-12);
  EXPECT_NEAR(beats[2].period_s, kEnd - 2 * kPeriod, 1e-12);
  EXPECT_DOUBLE_EQ(length, kEnd);
  EXPECT_NEAR(inflow, 3 * kEnd + (1 - std::cos(5 * kEnd)) / 5, 1e-5);
  EXPECT_NEAR(network, 7 * kEnd * kEnd, 1e-12);
  EXPECT_NEAR(work, kEnd * kEnd * kEnd, 1e-12);
}

}  // namespace
}  // namespace valsalva::run
