#include "casefile/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "casefile/unknown_key.hpp"
#include "common/nearest_name.hpp"

namespace valsalva::casefile {

namespace {

/// The value as the key wants it (5 for a real is 5.0, a number for a list is a list of one), or nothing.
CaseValue converted(const Key& key, const CaseValue& raw)
{
  const auto* x = std::get_if<double>(&raw);
  const auto* n = std::get_if<long>(&raw);
  switch (key.kind) {
    case KeyKind::real:
      if (n) return static_cast<double>(*n);
      return x ? raw : CaseValue{};
    case KeyKind::integer:
      if (n && std::abs(*n) <= 2147483647L) return raw;
      if (x && std::abs(*x) < 1e9 && *x == std::round(*x)) return std::lround(*x);
      return {};
    case KeyKind::reals:
      if (n) return std::vector<double>{static_cast<double>(*n)};
      if (x) return std::vector<double>{*x};
      return std::holds_alternative<std::vector<double>>(raw) ? raw : CaseValue{};
    case KeyKind::flag:
      return std::holds_alternative<bool>(raw) ? raw : CaseValue{};
    case KeyKind::text:
    case KeyKind::choice:
      return std::holds_alternative<std::string>(raw) ? raw : CaseValue{};
  }
  return {};
}

class Reader {
 public:
  Reader(const KeyTable& keys, std::vector<CaseProblem>& problems) : keys_(keys), problems_(problems) {}

  CheckedCase check(const RawDocument& document)
  {
    CheckedCase checked;
    report_unknown_tables(document);
    for (const KeySection& section : keys_.sections) {
      const auto written = document.sections.find(section.name);
      RawTable table{document.top.place, {}};
      if (section.name.empty())
        table = document.top;
      else if (written != document.sections.end())
        table = written->second;
      const std::string label = section.name.empty() ? "the top of the file" : "[" + section.name + "]";
      checked.sections[section.name] = check_table(table, section.keys, section.name, label);
    }
    for (const KeyArray& array : keys_.arrays) {
      checked.arrays[array.name];
      const auto written = document.arrays.find(array.name);
      if (written != document.arrays.end())
        checked.arrays[array.name] = check_entries(written->second, array);
    }
    return checked;
  }

 private:
  void note(const CasePlace& place, const std::string& key, const std::string& message)
  {
    problems_.push_back({place.file, place.line, place.column, key, message});
  }

  void report_unknown_tables(const RawDocument& document)
  {
    std::vector<std::string> known;
    for (const KeySection& section : keys_.sections)
      if (!section.name.empty()) known.push_back(section.name);
    for (const KeyArray& array : keys_.arrays) known.push_back(array.name);
    const auto report = [&](const std::string& name, const CasePlace& place, bool repeated) {
      if (repeated ? keys_.find_array(name) != nullptr : keys_.find_section(name) != nullptr) return;
      std::string message = "unknown section" + common::did_you_mean(name, known);
      if (common::nearest_name(name, known).empty()) message += "; known are " + common::one_of(known);
      if (keys_.find_array(name)) message = "write [[" + name + "]]: there may be several";
      if (keys_.find_section(name)) message = "write [" + name + "]: there is one only";
      note(place, name, message);
    };
    for (const auto& [name, table] : document.sections) report(name, table.place, false);
    for (const auto& [name, entries] : document.arrays)
      if (!entries.empty()) report(name, entries.front().place, true);
  }

  CaseTable check_table(const RawTable& raw, const std::vector<Key>& keys, const std::string& path,
                        const std::string& label)
  {
    CaseTable table(path, keys, raw.place);
    const std::string prefix = path.empty() ? "" : path + ".";
    std::set<std::string> mentioned;  // a key that was meant by a problem is not reported as missing as well
    for (const auto& [name, value] : raw.values) {
      const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
      if (key == keys.end()) {
        const UnknownKey unknown = describe_unknown(name, keys, label, keys_);
        note(value.place, prefix + name, unknown.message);
        mentioned.insert(unknown.meant);
        continue;
      }
      mentioned.insert(name);
      const CaseValue wanted = converted(*key, value.value);
      if (std::holds_alternative<std::monostate>(wanted)) {
        note(value.place, prefix + name, "found " + value.found + ", allowed is " + allowed_text(*key));
      } else if (const std::string problem = range_problem(*key, wanted); !problem.empty()) {
        note(value.place, prefix + name, problem);
      } else {
        table.set(name, wanted, value.place, true);
      }
    }
    for (const Key& key : keys)
      if (key.required && !mentioned.contains(key.name))
        note(raw.place, prefix + key.name, fmt::format("missing: {} ({})", key.meaning, allowed_text(key)));
    return table;
  }

  std::vector<CaseTable> check_entries(const std::vector<RawTable>& entries, const KeyArray& array)
  {
    std::vector<CaseTable> tables;
    std::map<std::string, CasePlace> names;
    for (const RawTable& raw : entries) {
      const std::string name = raw.name();
      if (const auto [first, is_new] = names.emplace(name, raw.place); !is_new && !name.empty())
        note(raw.place, array.name + "." + name,
             fmt::format("a second [[{}]] of this name; the first is in line {}", array.name,
                         first->second.line));
      if (name.find('.') != std::string::npos)
        note(raw.place, array.name + "." + name, "a name may not hold a dot");
      const KeyVariant* variant = nullptr;
      if (!array.variants.empty() && !(variant = find_variant(raw, array))) continue;
      const std::string label = "[[" + array.name + "]]" + (variant ? " of type " + variant->type : "");
      tables.push_back(check_table(raw, entry_keys(array, variant), array.name + "." + name, label));
    }
    return tables;
  }

  const KeyVariant* find_variant(const RawTable& raw, const KeyArray& array)
  {
    std::vector<std::string> types;
    for (const KeyVariant& variant : array.variants) types.push_back(variant.type);
    const std::string path = array.name + "." + raw.name() + ".type";
    const auto type = raw.values.find("type");
    if (type == raw.values.end()) {
      note(raw.place, path, "missing: allowed is " + common::one_of(types));
      return nullptr;
    }
    const auto* word = std::get_if<std::string>(&type->second.value);
    for (const KeyVariant& variant : array.variants)
      if (word && variant.type == *word) return &variant;
    note(type->second.place, path,
         "found " + type->second.found + ", allowed is " + common::one_of(types) +
             (word ? common::did_you_mean(*word, types) : ""));
    return nullptr;
  }

  static std::vector<Key> entry_keys(const KeyArray& array, const KeyVariant* variant)
  {
    std::vector<Key> keys = array.keys;
    if (!variant) return keys;
    keys.push_back(text("type", variant->meaning));
    keys.insert(keys.end(), variant->keys.begin(), variant->keys.end());
    return keys;
  }

  const KeyTable& keys_;
  std::vector<CaseProblem>& problems_;
};

}  // namespace

CheckedCase check_document(const RawDocument& document, const KeyTable& keys,
                           std::vector<CaseProblem>& problems)
{
  return Reader(keys, problems).check(document);
}

}  // namespace valsalva::casefile
