// A 3D-0D run: builds the model of a case, steps it to the end, writes everything, reports its progress.
#pragma once

#include "run/run.hpp"

namespace valsalva::run {

/// As `run_case`. Collective.
int run_coupled(const Case& c, const RunOptions& options, const Communicator& comm);

}  // namespace valsalva::run
