#include "casefile/case_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/nearest_name.hpp"

namespace valsalva::casefile {

namespace {

CasePlace place_of(const toml::node& node, const std::string& file)
{
  const toml::source_position begin = node.source().begin;
  return {file, static_cast<int>(begin.line), static_cast<int>(begin.column)};
}

RawValue raw_value(const toml::node& node, const CasePlace& place)
{
  const auto known = [&](CaseValue value) { return RawValue{value, toml_text(value), place}; };
  if (const auto* x = node.as_floating_point()) return known(x->get());
  if (const auto* n = node.as_integer()) return known(static_cast<long>(n->get()));
  if (const auto* on = node.as_boolean()) return known(on->get());
  if (const auto* words = node.as_string()) return known(words->get());
  if (const toml::array* list = node.as_array()) {
    std::vector<double> numbers;
    for (const toml::node& item : *list) {
      if (!item.is_number()) return {{}, "a list with something that is not a number", place};
      numbers.push_back(*item.value<double>());
    }
    return known(numbers);
  }
  return {{}, node.is_table() ? "a table" : "a date or time", place};
}

RawTable raw_table(const toml::table& table, const CasePlace& place)
{
  RawTable raw{place, {}};
  for (const auto& [key, node] : table) {
    const toml::source_position at = key.source().begin;
    raw.values[std::string(key.str())] =
        raw_value(node, {place.file, static_cast<int>(at.line), static_cast<int>(at.column)});
  }
  return raw;
}

RawDocument raw_document(const toml::table& root, const std::string& file)
{
  RawDocument document;
  document.top.place = {file, 0, 0};
  for (const auto& [key, node] : root) {
    const std::string name(key.str());
    const toml::array* list = node.as_array();
    if (const toml::table* table = node.as_table()) {
      document.sections[name] = raw_table(*table, place_of(node, file));
    } else if (list && !list->empty() && list->is_homogeneous<toml::table>()) {
      for (const toml::node& item : *list)
        document.arrays[name].push_back(raw_table(*item.as_table(), place_of(item, file)));
    } else {
      const toml::source_position at = key.source().begin;
      document.top.values[name] =
          raw_value(node, {file, static_cast<int>(at.line), static_cast<int>(at.column)});
    }
  }
  return document;
}

void merge(RawTable& base, const RawTable& winner)
{
  for (const auto& [key, value] : winner.values) base.values[key] = value;
  base.place = winner.place;
}

RawTable* find_entry(std::vector<RawTable>& entries, const std::string& name)
{
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const RawTable& e) { return e.name() == name; });
  return found == entries.end() ? nullptr : &*found;
}

/// An entry of the base keeps its keys unless the extending file makes it another type.
bool changes_type(const RawTable& base, const RawTable& winner)
{
  const auto a = base.values.find("type"), b = winner.values.find("type");
  return b != winner.values.end() && (a == base.values.end() || a->second.value != b->second.value);
}

void merge(RawDocument& base, const RawDocument& winner)
{
  merge(base.top, winner.top);
  for (const auto& [name, section] : winner.sections) merge(base.sections[name], section);
  for (const auto& [name, entries] : winner.arrays) {
    // Names twice in one file must stay two entries, to be reported: only entries of the base are merged
    // into.
    const std::size_t base_count = base.arrays[name].size();
    for (const RawTable& entry : entries) {
      RawTable* same = find_entry(base.arrays[name], entry.name());
      const bool of_base = same && !entry.name().empty() && same < base.arrays[name].data() + base_count;
      if (!of_base)
        base.arrays[name].push_back(entry);
      else if (changes_type(*same, entry))
        *same = entry;
      else
        merge(*same, entry);
    }
  }
}

RawDocument parse_chain(const std::string& toml, const std::string& file, std::vector<std::string>& chain,
                        std::vector<CaseProblem>& problems)
{
  RawDocument document;
  document.top.place = {file, 0, 0};
  try {
    document = raw_document(toml::parse(toml, file), file);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    problems.push_back({file, static_cast<int>(at.line), static_cast<int>(at.column), "",
                        "this is not TOML: " + std::string(error.description())});
    return document;
  }
  const auto extends = document.top.values.find("extends");
  if (extends == document.top.values.end()) return document;
  const RawValue given = extends->second;
  document.top.values.erase(extends);
  const auto refuse = [&](const std::string& message) {
    problems.push_back({file, given.place.line, given.place.column, "extends", message});
    return document;
  };
  const auto* relative = std::get_if<std::string>(&given.value);
  if (!relative) return refuse("found " + given.found + ", allowed is the path of a case file in quotes");
  const std::string base_file =
      (std::filesystem::path(file).parent_path() / *relative).lexically_normal().string();
  if (std::find(chain.begin(), chain.end(), base_file) != chain.end())
    return refuse("the file " + base_file + " extends itself in the end; break the circle");
  chain.push_back(base_file);
  std::string base_text;
  try {
    base_text = read_text(base_file);
  } catch (const IoError&) {
    return refuse("no file " + base_file + "; the path is relative to the file that extends");
  }
  RawDocument base = parse_chain(base_text, base_file, chain, problems);
  merge(base, document);
  return base;
}

}  // namespace

std::string RawTable::name() const
{
  const auto found = values.find("name");
  const std::string* words = found == values.end() ? nullptr : std::get_if<std::string>(&found->second.value);
  return words ? *words : "";
}

RawDocument parse_document(const std::string& toml, const std::string& file,
                           std::vector<CaseProblem>& problems)
{
  std::vector<std::string> chain{std::filesystem::path(file).lexically_normal().string()};
  return parse_chain(toml, file, chain, problems);
}

void apply_override(RawDocument& document, const std::string& override_text,
                    std::vector<CaseProblem>& problems)
{
  const CasePlace place{"--set", 0, 0};
  const auto refuse = [&](const std::string& key, const std::string& message) {
    problems.push_back({place.file, 0, 0, key, message});
  };
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0)
    return refuse("", "found '" + override_text + "', allowed is key=value, e.g. grid.finest_cm=0.15625");
  const std::string path = override_text.substr(0, equals), words = override_text.substr(equals + 1);
  RawValue value{words, toml_text(words), place};
  try {
    const toml::table parsed = toml::parse("value = " + words);
    if (parsed.size() == 1) value = raw_value(*parsed.get("value"), place);
  } catch (const toml::parse_error&) {
    // A bare word: it stays the text it is.
  }
  const std::size_t first = path.find('.'), last = path.rfind('.');
  if (first == std::string::npos) {
    document.top.values[path] = value;
  } else if (first == last) {
    RawTable& section =
        document.sections.try_emplace(path.substr(0, first), RawTable{place, {}}).first->second;
    section.values[path.substr(first + 1)] = value;
  } else {
    const std::string array = path.substr(0, first), name = path.substr(first + 1, last - first - 1);
    std::vector<std::string> names;
    for (const RawTable& entry : document.arrays[array]) names.push_back(entry.name());
    RawTable* entry = find_entry(document.arrays[array], name);
    if (!entry)
      return refuse(path, "no [[" + array + "]] is named '" + name + "'" + common::did_you_mean(name, names));
    entry->values[path.substr(last + 1)] = value;
  }
}

std::string read_text(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream all;
  if (std::filesystem::is_directory(path) || !stream || !(all << stream.rdbuf()))
    throw IoError("cannot read the case file '" + path + "'; check the path and its permissions");
  return all.str();
}

}  // namespace valsalva::casefile
