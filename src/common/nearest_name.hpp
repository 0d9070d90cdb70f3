// "Did you mean ...?": the known name that is fewest typing errors (insert, delete, replace, swap) away.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace valsalva::common {

/// Typing errors between two names, upper and lower case counted as equal.
std::size_t typing_errors(std::string_view a, std::string_view b);

/// The nearest of `known` to `name`, or an empty text if none is within a third of its length (at least 2
/// errors).
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// "; did you mean 'finest_cm'?" or an empty text.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

/// "a", "a or b", "a, b or c".
std::string one_of(const std::vector<std::string>& words);

}  // namespace valsalva::common
