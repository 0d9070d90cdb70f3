// `valsalva check`: what a case will build and cost, from a few trial steps; writes nothing.
#pragma once

#include <string>

#include "casefile/case_file.hpp"

namespace valsalva::run {

/// Sizes of grid and structure, memory, stable step and estimated time, as lines for a terminal. Throws
/// CaseError for everything that a run would refuse.
std::string describe_case(const CaseFile& case_file);

}  // namespace valsalva::run
