// Fields and structure at regular times, as files that ParaView opens: fields/fields_NNNN.hdf,
// structure/leaflets_NNNN.hdf, and structure/wall.hdf once (the wall hardly moves). All calls are collective.
#pragma once

#include <optional>
#include <string>

#include "common/comm.hpp"
#include "coupling/model_from_case.hpp"
#include "ib3d/output/file_series.hpp"

namespace valsalva::coupling {

class Snapshots {
 public:
  Snapshots(const std::string& folder, const CaseFile& c, CaseModel& model, const Communicator& comm);

  /// The next time at which something is to be written (s): steps should land on it.
  double next_time() const { return std::min(fields_.next_s, structure_.next_s); }
  /// Writes what is due at the model's time.
  void write_due();

 private:
  struct Schedule {
    double every_s = 0, next_s = 0;
    int count = 0;
    bool due(double t) const { return t > next_s - 1e-9; }
    void done() { next_s = ++count * every_s; }
  };
  void write_fields(double t);
  void write_structure(const std::string& path, double t, bool wall);

  std::string folder_;
  CaseModel& model_;
  Communicator comm_;
  Schedule fields_, structure_;
  std::optional<ib3d::FileSeries> field_series_, structure_series_;  ///< on rank 0
};

}  // namespace valsalva::coupling
