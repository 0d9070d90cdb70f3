// Whether the beats of a run repeat: the largest relative change from one beat to the next of
//     net stroke volume, mean, systolic and diastolic aortic pressure
// A run with time.stop_when_periodic_within = tolerance ends after the first beat that changes by less. Beats that
// the end of the run cuts short do not count.
#pragma once

#include <string>

#include "common/checkpoint.hpp"
#include "run/beats/beat_metrics.hpp"

namespace valsalva::run {

class PeriodicBeats {
 public:
  /// `tolerance` 0: never reached; `period_s` of a whole beat.
  PeriodicBeats(double tolerance, double period_s) : tolerance_(tolerance), period_s_(period_s) {}

  /// Takes note of a beat that has ended; returns the line about it for the log.
  std::string add(const BeatMetrics& beat);
  /// Has the last beat changed by less than the tolerance?
  bool reached() const { return change_ >= 0 && change_ < tolerance_; }
  /// "periodic after 7 beats", where `reached`.
  std::string outcome() const;
  /// All but the tolerance, which may be another one in a continued run.
  void save_or_restore(Checkpoint& c);

 private:
  double tolerance_, period_s_;
  double change_ = -1;  ///< of the last beat; negative: not known
  double beat_ = 0;     ///< number of the last beat
  double stroke_volume_ = 0, p_mean_ = 0, p_systolic_ = 0, p_diastolic_ = 0;
};

}  // namespace valsalva::run
