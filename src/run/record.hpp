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
  double peak_memory_mb = 0;
  long steps = 0, cells = 0, nodes = 0;
};

/// Measures the memory and writes folder/run.json, as a whole. While the outcome is "running", room on the disk is
/// set aside for what the record says last (run.json.part). IoError on all ranks. Collective.
void write_run_record(const std::string& folder, RunRecord& record, const Communicator& comm);

/// Writes the record, with the outcome "failed", from this rank alone; a record that cannot be written stays as it was.
void write_failed_run_record(const std::string& folder, RunRecord record, const Communicator& comm);

/// The most memory that this program has held so far, MB, all ranks together. Collective.
double peak_memory_mb(const Communicator& comm);

}  // namespace valsalva::run
