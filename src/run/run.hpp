// `valsalva run`: a case from its start to its end, with all its output. Collective.
#pragma once

#include <string>

#include "casefile/case_file.hpp"

namespace valsalva::run {

struct RunOptions {
  std::string case_path;
  std::string out_dir;
  bool lumped = false;           ///< in 0D, with the surrogate in place of the 3D root
  bool force = false;            ///< replace what is in `out_dir`
  std::string restart;           ///< checkpoint to continue from: a file, "latest", or empty for a new run
  std::string continue_command;  ///< what to type to continue this run, for people
};

/// Runs the case and writes into `options.out_dir`, which this call creates. Returns the exit code: 0, also
/// after a signal has ended the run early with all output complete and a checkpoint to continue from. Throws CaseError (the same on all ranks),
/// SolverError, IoError.
int run_case(const CaseFile& case_file, const RunOptions& options);

}  // namespace valsalva::run
