// JSON by the library of N. Lohmann, keys in the order in which they are set. Slow to compile: include it in .cpp files.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace valsalva::common {

using Json = nlohmann::ordered_json;

/// Rounded to nine significant digits, as in the CSV files. What is not finite is written as null.
inline double nine_digits(double x)
{
  return std::stod(fmt::format("{:.9g}", x));
}

/// A whole file; bytes that are not UTF-8 (in a path, say) are replaced.
inline std::string json_text(const Json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace valsalva::common
