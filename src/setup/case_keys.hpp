// All keys of a Valsalva case: the one place where they are named, with unit, range, default and meaning.
#pragma once

#include "casefile/case_key.hpp"

namespace valsalva::setup {

/// Built at the first call.
const casefile::KeyTable& case_keys();

}  // namespace valsalva::setup
