// Statistics of the current beat, of a 3D and of a 0D run alike: a sample of every step, and the totals of volume and
// energy at its start. Closing the beat gives its metrics with its balance (beat_metrics.hpp, beat_balance.hpp); the
// last sample and the totals are then the first of the next beat. Beats count from 1; beat n ends at n times the heart
// period (s), and a run may end within it.
#pragma once

#include <vector>

#include "common/checkpoint.hpp"
#include "run/beats/beat_metrics.hpp"

namespace valsalva::run {

class BeatStatistics {
 public:
  /// The heart period, s, > 0.
  explicit BeatStatistics(double period_s) : period_s_(period_s) {}

  /// Starts beat 1; its samples follow by `add`.
  void begin(const BalanceState& now) { at_begin_ = now; }
  /// Samples in order of time, the first at the beat's start.
  void add(const BeatSample& sample) { samples_.push_back(sample); }
  /// Does the current beat have a sample after its start?
  bool has_begun() const { return samples_.size() > 1; }
  /// Metrics and balance of the beat that ends `now`, at the latest sample; there must be one.
  BeatMetrics close(const BalanceState& now);
  /// All but the period. Collective.
  void save_or_restore(Checkpoint& c);

  /// Number of the current beat, from 1, and when it ends.
  int beat() const { return beat_; }
  double end_s() const { return beat_ * period_s_; }
  /// Of the samples added; there must be one.
  const BeatSample& latest() const { return samples_.back(); }

 private:
  double period_s_;
  int beat_ = 1;
  std::vector<BeatSample> samples_;
  BalanceState at_begin_;  ///< of the beat
};

}  // namespace valsalva::run
