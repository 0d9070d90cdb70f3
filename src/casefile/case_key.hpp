// The declarative table of all keys a case file may hold. Every key stands once: kind, unit, range, default
// and a one-line meaning; validation, the commented template (`valsalva keys`), docs/keys.md and the resolved
// case all come from it. Build keys with the functions below, e.g.
//   real("finest_cm", "cm", "Spacing of the finest level").in(0.001, 1.0).or_else(0.104167)
//   choice("sides", {"wall", "open"}, "Side walls").or_else("wall")
// A key without `or_else` is required unless `optional()`.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace valsalva::casefile {

enum class KeyKind { real, integer, flag, text, choice, reals };

/// The value of a key; std::monostate where an optional key is absent.
using CaseValue = std::variant<std::monostate, double, long, bool, std::string, std::vector<double>>;

struct Key {
  std::string name;  ///< within its section, the unit as its ending: "finest_cm"
  KeyKind kind = KeyKind::real;
  std::string unit;  ///< human-readable: "cm", "mmHg s/ml"; empty if it has none
  std::string meaning;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_excluded = false;      ///< the value must lie above `lowest`
  std::size_t count = 0;             ///< how many numbers a `reals` must have; 0: any number of them
  std::vector<std::string> choices;  ///< of a `choice`
  CaseValue otherwise;               ///< the default
  CaseValue usual;                   ///< of a key without default: a value to offer in the template
  bool required = true;

  Key in(double low, double high) const;    ///< low <= value <= high
  Key at_least(double low) const;           ///< low <= value
  Key above(double low) const;              ///< low < value
  Key of_count(std::size_t numbers) const;  ///< a list of exactly so many numbers
  Key optional() const;                     ///< may be absent; then `has(key)` is false
  Key or_else(double value) const;          ///< default of a real or an integer
  Key or_else(const char* value) const;     ///< default of a text or a choice
  Key or_else(bool value) const;
  Key or_else(int value) const;
  Key or_else(std::vector<double> value) const;
  Key example(double value) const;  ///< offered in the template, never taken by itself
};

Key real(std::string name, std::string unit, std::string meaning);
Key integer(std::string name, std::string meaning);
Key flag(std::string name, std::string meaning);
Key text(std::string name, std::string meaning);
Key choice(std::string name, std::vector<std::string> choices, std::string meaning);
Key reals(std::string name, std::string unit, std::string meaning);

/// `[name]`, once per case; the section with the empty name holds the keys above the first header.
struct KeySection {
  std::string name;
  std::string meaning;
  std::vector<Key> keys;
};

/// One kind of entry of a repeated section, chosen by the entry's key `type`.
struct KeyVariant {
  std::string type;
  std::string meaning;
  std::vector<Key> keys;
};

/// `[[name]]`, any number of times; every entry has a unique key `name`. `keys` are common to all entries; if
/// there are `variants`, every entry also has a key `type` (do not list it) and the keys of its variant.
struct KeyArray {
  std::string name;
  std::string meaning;
  std::vector<Key> keys;
  std::vector<KeyVariant> variants;
};

struct KeyTable {
  std::vector<KeySection> sections;
  std::vector<KeyArray> arrays;
  const KeySection* find_section(std::string_view name) const;
  const KeyArray* find_array(std::string_view name) const;
};

/// "from 0.05 to 0.5", "above 0 cm", "wall, open or periodic", "3 numbers": what a key allows, in words.
std::string allowed_text(const Key& key);

/// The value as TOML writes it: 0.104167, [1.0, 2.0], "wall", true.
std::string toml_text(const CaseValue& value);

/// Is `value` of the kind of `key` and inside its range? An empty text if so, else one sentence.
std::string range_problem(const Key& key, const CaseValue& value);

}  // namespace valsalva::casefile
