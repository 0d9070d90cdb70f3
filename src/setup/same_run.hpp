// Whether a checkpoint belongs to a case: only keys that leave the solution alone (title, [output] without
// probes_z_cm, [checkpoint], time.end_s, time.stop_when_periodic_within) may change between a run and its continuation.
#pragma once

#include <string>

#include "setup/case.hpp"

namespace valsalva::setup {

/// CaseError that names the keys by which `now` is another run than the one that wrote `checkpoint`, whose resolved
/// case is `then`.
void check_same_run(const Case& now, const std::string& then, const std::string& checkpoint);

}  // namespace valsalva::setup
