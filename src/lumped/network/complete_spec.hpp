// The one place where element parameters are checked against the table of element types.
#pragma once

#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

/// The spec with all defaults filled in. Throws one CaseError with every problem: unknown types and
/// parameters (with the nearest known name), missing or wrong ones, values out of range, nodes missing, names
/// used twice.
NetworkSpec complete_spec(NetworkSpec spec);

}  // namespace valsalva::lumped
