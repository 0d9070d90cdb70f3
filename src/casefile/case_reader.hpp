// Checks a document as written against the table of keys and fills in the defaults. Every problem is recorded and
// reading continues, so that a user sees all of them at once.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "casefile/case_document.hpp"

namespace valsalva::casefile {

struct CheckedCase {
  std::map<std::string, CaseTable, std::less<>> sections;
  std::map<std::string, std::vector<CaseTable>, std::less<>> arrays;
};

/// All sections and arrays of `keys`, checked; what is wrong is appended to `problems`, and only if there are
/// none may the result be used.
CheckedCase check_document(const RawDocument& document, const KeyTable& keys,
                           std::vector<CaseProblem>& problems);

}  // namespace valsalva::casefile
