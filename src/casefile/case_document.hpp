// A TOML file as it was written, before any check: sections, entries of repeated sections, and values with
// their places. `extends` is followed here and overrides are applied here; what the keys mean is the reader's
// concern.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "casefile/case_file.hpp"

namespace valsalva::casefile {

struct RawValue {
  CaseValue value;    ///< std::monostate: something no key may be (a date, a table, a list of texts, ...)
  std::string found;  ///< the same in words, for messages
  CasePlace place;
};

struct RawTable {
  CasePlace place;
  std::map<std::string, RawValue> values;
  /// The entry's `name`, or an empty text.
  std::string name() const;
};

struct RawDocument {
  RawTable top;
  std::map<std::string, RawTable> sections;
  std::map<std::string, std::vector<RawTable>> arrays;
};

/// Parses `toml` and what it extends. Syntax errors and impossible `extends` go to `problems`.
RawDocument parse_document(const std::string& toml, const std::string& file,
                           std::vector<CaseProblem>& problems);

/// Applies "section.key=value", "array.name.key=value" and "key=value" (value as in TOML; bare words are
/// texts).
void apply_override(RawDocument& document, const std::string& override_text,
                    std::vector<CaseProblem>& problems);

/// The file's text; IoError if it cannot be read.
std::string read_text(const std::string& path);

}  // namespace valsalva::casefile
