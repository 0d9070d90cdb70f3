#include "run/beats/beat_statistics.hpp"

namespace valsalva::run {

BeatMetrics BeatStatistics::close(const BalanceState& now)
{
  BeatMetrics metrics = measure_beat(beat_, samples_);
  metrics.balance = balance_between(at_begin_, now);
  at_begin_ = now;
  samples_ = {samples_.back()};
  ++beat_;
  return metrics;
}

void BeatStatistics::save_or_restore(Checkpoint& c)
{
  c("traces/beat", beat_);
  c("traces/samples", samples_);
  std::vector<BalanceState> balance{at_begin_};
  c("traces/balance_at_begin", balance);
  at_begin_ = balance.at(0);
}

}  // namespace valsalva::run
