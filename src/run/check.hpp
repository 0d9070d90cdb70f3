// `valsalva check`: what a case will build and cost, from a few trial steps; writes nothing.
#pragma once

#include <string>

#include "common/comm.hpp"
#include "setup/case.hpp"

namespace valsalva::run {

/// Sizes of grid and structure, memory, stable step and estimated time, as lines for a terminal. Throws
/// CaseError for everything that a run would refuse.
std::string describe_case(const setup::Case& c, const Communicator& comm);

}  // namespace valsalva::run
