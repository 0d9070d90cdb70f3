// What was built, in lines for people: grid, structure, leaflets, step, markers, coupling. Used by `run` and `check`.
#pragma once

#include <string>

#include "setup/build_model.hpp"

namespace valsalva::run {

/// Collective.
std::string describe_model(const setup::Case& c, setup::CaseModel& model);

}  // namespace valsalva::run
