// What no single key can say: values of a case that do not fit together.
#pragma once

#include <vector>

#include "setup/case.hpp"

namespace valsalva::setup {

/// One problem per contradiction, keyed "section.key" or "array.name.key"; empty if the case is sound. The places are
/// added by CaseFile::locate.
std::vector<CaseProblem> problems_of(const Case& c);

/// Of an aortic root: dimensions that do not fit each other, the box, or the grid.
std::vector<CaseProblem> root_problems(const Case& c);

}  // namespace valsalva::setup
