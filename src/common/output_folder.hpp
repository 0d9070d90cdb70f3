// The folder a run writes into: never overwritten unless asked for, and then only if it is the output of a
// run.
#pragma once

#include <string>

#include "common/comm.hpp"

namespace valsalva::common {

/// CaseError (the same on all ranks) if `folder` holds something and `force` does not allow to replace it, or
/// if it holds something else than the output of a run. Changes nothing. Collective.
void check_output_folder(const std::string& folder, bool force, const Communicator& comm);

/// Checks, clears and creates the folder on rank 0 and writes `resolved_case` into it as case.resolved.toml,
/// the file by which an output folder is known. IoError (on all ranks) if it cannot. Collective.
void create_output_folder(const std::string& folder, bool force, const std::string& resolved_case,
                          const Communicator& comm);

/// Replaces case.resolved.toml in the folder of an earlier run as a whole. CaseError (on all ranks) if `folder` holds
/// no run. Collective.
void continue_output_folder(const std::string& folder, const std::string& resolved_case,
                            const Communicator& comm);

/// "cases/aortic_root/case.toml" -> "out/aortic_root"; a file of another name, ".../smoke.toml" ->
/// "out/aortic_root-smoke".
std::string usual_output_folder(const std::string& case_path);

}  // namespace valsalva::common
