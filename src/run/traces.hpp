// The CSV traces of a coupled run: step.csv, openings.csv, probes.csv, and beats.csv from them.
// Every flow is positive along +z, from the ventricle to the aorta. Rank 0 writes; all calls are collective.
#pragma once

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
  Traces(const std::string& folder, const CaseFile& c, setup::CaseModel& model, const Communicator& comm);

  /// Creates the files and writes the row of t = 0.
  void begin();
  /// The beat under way and the ends of the files; reading, cuts the files back to there and goes on behind.
  void save_or_restore(Checkpoint& c);
  /// One more step; returns the beat's metrics when the step ends a beat.
  std::optional<BeatMetrics> record(const coupling::StepReport& step, double wall_s);
  /// The row of the beat under way, when the run ends within it; returns its metrics.
  std::optional<BeatMetrics> finish();
  /// Everything written so far is in the files afterwards.
  void flush();

  /// The latest sample, for the progress line.
  const BeatSample& latest() const { return books_.latest(); }
  /// Number of the beat under way, from 1.
  int beat() const { return books_.beat(); }
  /// The end of the beat under way (s): steps should land on it.
  double beat_end() const { return books_.end_s(); }

 private:
  struct File {
    std::string name;
    std::vector<std::string> columns;
    std::optional<TimeSeriesWriter> writer;  ///< on rank 0
  };
  std::string path_of(const File& file) const { return folder_ + "/" + file.name + ".csv"; }
  void write_row(const coupling::StepReport& step, double wall_s);
  std::vector<double> probe_row();
  BeatMetrics close_beat();

  std::string folder_;
  setup::CaseModel& model_;
  Communicator comm_;
  BeatStatistics books_;
  int every_;
  std::vector<double> probes_z_, centre_;
  double valve_radius_ = 0, upstream_z_ = 0, downstream_z_ = 0, downstream_radius_ = 0;
  std::vector<int> edge_nodes_;
  File steps_, openings_, probes_, beats_;
  double q_upstream_ = 0, q_downstream_ = 0, orifice_ = -1;
};

}  // namespace valsalva::run
