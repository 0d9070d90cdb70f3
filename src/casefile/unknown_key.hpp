// What to say about a key that no table knows: its unit is another one, it belongs elsewhere, or it is
// misspelt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "casefile/case_key.hpp"

namespace valsalva::casefile {

/// A unit as it ends the names of keys: "mmHg s^2/ml" -> "mmHg_s2_ml", "1/s" -> "1_s".
std::string unit_suffix(std::string_view unit);

/// The key with the same stem as `name` but another unit, or none: "pressure_kPa" -> the key "pressure_mmHg".
/// nullptr if there is none.
const Key* key_with_other_unit(std::string_view name, const std::vector<Key>& keys);

struct UnknownKey {
  std::string message;
  std::string meant;  ///< the known key of the same table that was probably meant, or empty
};

/// One sentence for the unknown key `name` of a table with `keys`, called `table` in messages ("[grid]").
UnknownKey describe_unknown(std::string_view name, const std::vector<Key>& keys, const std::string& table,
                            const KeyTable& all);

}  // namespace valsalva::casefile
