// `valsalva run`: a case from its start to its end, with all its output. Collective.
#pragma once

#include <string>

#include "common/comm.hpp"
#include "setup/case.hpp"

namespace valsalva::run {

using setup::Case;

struct RunOptions {
  std::string case_path;
  std::string out_dir;
  bool lumped = false;           ///< in 0D, with the surrogate in place of the 3D root
  bool force = false;            ///< replace what is in `out_dir`
  std::string restart;           ///< checkpoint to continue from: a file, "latest", or empty for a new run
  std::string continue_command;  ///< what to type to continue this run, for people
};

/// Runs the case and writes into `options.out_dir`, which this call creates. Returns the exit code: 0, also after a
/// signal has ended the run early with all output complete and a checkpoint to continue from. Throws CaseError (the same
/// on all ranks), SolverError, IoError. Collective.
int run_case(const Case& c, const RunOptions& options, const Communicator& comm);

}  // namespace valsalva::run
