// Text as a JSON string.
#pragma once

#include <string>

namespace valsalva::common {

/// `text` in double quotes, control characters removed.
std::string json_quoted(const std::string& text);

}  // namespace valsalva::common
