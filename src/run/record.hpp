// run.json: who ran what, where, how long, with how much memory.
#pragma once

#include <string>

#include "common/comm.hpp"

namespace valsalva::run {

/// s, and numbers of steps, valid cells and nodes.
struct RunRecord {
  std::string case_path;
  std::string outcome;  ///< "running", "finished", "stopped by a signal", "failed"
  double t_s = 0, wall_s = 0;
  long steps = 0, cells = 0, nodes = 0;
};

/// Writes folder/run.json on rank 0 (replaced as a whole). Collective.
void write_run_record(const std::string& folder, const RunRecord& record, const Communicator& comm);

/// The most memory that this program has held so far, MB, all ranks together. Collective.
double peak_memory_mb(const Communicator& comm);

}  // namespace valsalva::run
