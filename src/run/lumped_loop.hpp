// A purely 0D run: the network of a case alone, a 3D root replaced by its surrogate, through the same command,
// with the same openings.csv and beats.csv.
#pragma once

#include "run/run.hpp"

namespace valsalva::run {

/// As `run_case`, in 0D whatever the case. Rank 0 computes; collective.
int run_lumped(const Case& c, const RunOptions& options, const Communicator& comm);

}  // namespace valsalva::run
