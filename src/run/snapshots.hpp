// Fields and structure at regular times, as files that ParaView opens: fields/fields_NNNN.hdf,
// structure/leaflets_NNNN.hdf and structure/markers_NNNN.hdf, and structure/wall.hdf once (the wall hardly moves). All
// calls are collective.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "common/checkpoint.hpp"
#include "common/comm.hpp"
#include "ib3d/output/file_series.hpp"
#include "setup/build_model.hpp"

namespace valsalva::run {

class Snapshots {
 public:
  /// Plans the files; writes none. `model` must outlive the object. IoError if a list of files cannot be read.
  Snapshots(const std::string& folder, const setup::Output& output, setup::CaseModel& model,
            const Communicator& comm);

  /// The next time at which something is to be written (s): steps should land on it.
  double next_time() const { return std::min(fields_.next_s, structure_.next_s); }
  /// Writes what is due at the model's time.
  void write_due();
  /// Saves the number of files; on restore truncates the lists of files to it. The intervals may have changed.
  void save_or_restore(Checkpoint& c);

 private:
  struct Schedule {
    double every_s = 0;  ///< infinite: never
    double next_s = 0;
    int count = 0;  ///< files so far
    bool due(double t) const { return t > next_s - kSameTime_s; }
    void plan_after(double t) { next_s = (std::floor((t + kSameTime_s) / every_s) + 1) * every_s; }
    void done(double t)
    {
      ++count;
      plan_after(t);
    }
  };
  static constexpr double kSameTime_s = 1e-9;
  /// Adds a file to its list. Collective.
  void list(std::optional<ib3d::FileSeries>& series, const std::string& name, double t) const;
  void write_fields(double t);
  void write_structure(const std::string& path, double t, bool wall);
  void write_markers(const std::string& path, double t);

  std::string folder_;
  setup::CaseModel& model_;
  Communicator comm_;
  Schedule fields_, structure_;
  bool has_structure_, has_markers_;
  std::optional<ib3d::FileSeries> field_series_, structure_series_, marker_series_;  ///< on rank 0
};

}  // namespace valsalva::run
