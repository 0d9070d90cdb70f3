// The CSV traces of a coupled run: step.csv, openings.csv, probes.csv, and beats.csv from them.
// Every flow is positive along +z, from the ventricle to the aorta. Rank 0 writes; all calls are collective.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "common/checkpoint.hpp"
#include "common/comm.hpp"
#include "common/time_series.hpp"
#include "run/beats/beat_statistics.hpp"
#include "setup/build_model.hpp"

namespace valsalva::run {

class Traces {
 public:
  /// Writes nothing yet. `model` must outlive the object.
  Traces(const std::string& folder, const setup::Case& c, setup::CaseModel& model, const Communicator& comm);

  /// Creates the files and writes the row of t = 0.
  void begin();
  /// Saves the current beat's samples and each CSV's length; on restore truncates to those lengths and appends.
  void save_or_restore(Checkpoint& c);
  /// Takes a sample of the step, and writes its row when one is due; returns the beat's metrics when the step ends a beat.
  /// Collective.
  std::optional<BeatMetrics> record(const coupling::StepReport& step, double wall_s);
  /// The row of the current beat, when the run ends within it; returns its metrics.
  std::optional<BeatMetrics> finish();
  /// Afterwards everything written so far is in the files.
  void flush();

  /// The latest sample, for the progress line.
  const BeatSample& latest() const { return statistics_.latest(); }
  /// Number of the current beat, from 1.
  int beat() const { return statistics_.beat(); }
  /// The end of the current beat (s): steps should land on it.
  double beat_end() const { return statistics_.end_s(); }

 private:
  struct File {
    std::string name;
    std::vector<std::string> columns;
    std::optional<TimeSeriesWriter> writer;  ///< on rank 0
  };
  std::string path_of(const File& file) const { return folder_ + "/" + file.name + ".csv"; }
  /// What the beat statistics take from the model as it is now.
  BeatSample sample() const;
  void write_row(const coupling::StepReport& step, double wall_s);
  std::vector<double> probe_row() const;
  BeatMetrics close_beat();

  std::string folder_;
  setup::CaseModel& model_;
  Communicator comm_;
  BeatStatistics statistics_;
  int every_;
  std::vector<double> probes_z_;
  std::array<double, 2> centre_;
  double valve_radius_ = 0, upstream_z_ = 0, downstream_z_ = 0, downstream_radius_ = 0;
  std::vector<int> edge_nodes_;
  File steps_, openings_, probes_, beats_;
};

}  // namespace valsalva::run
