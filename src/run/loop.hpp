// A 3D-0D run: builds the model of a case, steps it to the end, writes everything, says what it is doing.
#pragma once

#include "common/comm.hpp"
#include "run/run.hpp"
#include "setup/build_model.hpp"

namespace valsalva::run {

/// As `run_case`. Collective.
int run_coupled(const CaseFile& c, const RunOptions& options);

/// What was built, in lines for people: grid, structure, leaflets, coupling. Used by `run` and `check`.
/// Collective.
std::string describe_model(const CaseFile& c, setup::CaseModel& model);

}  // namespace valsalva::run
