// All keys of a Valsalva case: the one place where they are named, with unit, range, default and meaning.
#pragma once

#include "common/case_key.hpp"

namespace valsalva::coupling {

/// Built at the first call.
const common::KeyTable& case_keys();

}  // namespace valsalva::coupling
