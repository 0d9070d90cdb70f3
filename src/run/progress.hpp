// Where a 3D run is: a line every few seconds, and a live bar in between where the output is a terminal.
#pragma once

#include "common/log.hpp"
#include "coupling/coupled_model.hpp"
#include "run/beats/beat_metrics.hpp"

namespace valsalva::run {

class ProgressLines {
 public:
  /// `wall_s` is the clock now; `every_s` the seconds on it between two lines.
  ProgressLines(Log& log, const coupling::CoupledModel& now, double end_s, double every_s, double wall_s);

  /// After a step, at its end `now` in beat number `beat`.
  void tell(const coupling::StepReport& step, const BeatSample& now, int beat, double wall_s);

 private:
  Log& log_;
  double begin_s_, end_s_, every_s_, begun_, told_, shown_;
  long told_step_;
};

}  // namespace valsalva::run
