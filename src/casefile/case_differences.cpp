// What differs between two cases, key by key.
#include <fmt/format.h>

#include "casefile/case_file.hpp"

namespace valsalva::casefile {

namespace {

std::string value_text(const CaseValue& value)
{
  return std::holds_alternative<std::monostate>(value) ? "absent" : toml_text(value);
}

void add_differences(const CaseTable& now, const CaseTable& then, std::vector<CaseProblem>& found)
{
  for (const Key& key : now.keys()) {
    if (!then.knows(key.name)) continue;  // an entry of another type, which its key "type" tells
    const CaseValue &here = now.value(key.name), &there = then.value(key.name);
    if (here != there)
      found.push_back(
          now.problem(key.name, fmt::format("is {} now, was {}", value_text(here), value_text(there))));
  }
}

}  // namespace

std::vector<CaseProblem> CaseFile::differences_from(const CaseFile& earlier) const
{
  std::vector<CaseProblem> found;
  for (const auto& [name, table] : sections_) add_differences(table, earlier.section(name), found);
  for (const auto& [name, entries] : arrays_) {
    for (const CaseTable& entry_now : entries) {
      if (const CaseTable* then = earlier.entry(name, entry_now.text("name")))
        add_differences(entry_now, *then, found);
      else
        found.push_back(entry_now.problem("", "is new"));
    }
    for (const CaseTable& then : earlier.tables(name))
      if (!entry(name, then.text("name"))) found.push_back({path_, 0, 0, then.path(), "is missing now"});
  }
  return found;
}

}  // namespace valsalva::casefile
