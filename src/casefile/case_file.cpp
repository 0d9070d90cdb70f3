#include "casefile/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <tuple>

#include "casefile/case_document.hpp"
#include "casefile/case_reader.hpp"

namespace valsalva::casefile {

namespace {

void sort_by_place(std::vector<CaseProblem>& problems)
{
  std::stable_sort(problems.begin(), problems.end(), [](const CaseProblem& a, const CaseProblem& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
}

/// The parts of a key as physics code may write it: element "arteries": C_ml_mmHg.
struct QuotedKey {
  std::string word, quoted, rest;
};

QuotedKey split_quoted(const std::string& key)
{
  const std::size_t open = key.find(" \"");
  const std::size_t close = open == std::string::npos ? open : key.find('"', open + 2);
  if (close == std::string::npos) return {key, "", ""};
  const bool has_rest = key.compare(close, 3, "\": ") == 0;
  return {key.substr(0, open), key.substr(open + 2, close - open - 2), has_rest ? key.substr(close + 3) : ""};
}

void put(CaseProblem& problem, const CasePlace& place)
{
  problem.file = place.file;
  problem.line = place.line;
  problem.column = place.column;
}

}  // namespace

CaseFile CaseFile::read(const std::string& path, const KeyTable& keys,
                        const std::vector<std::string>& overrides)
{
  return parse(read_text(path), path, keys, overrides);
}

CaseFile CaseFile::parse(const std::string& toml, const std::string& name, const KeyTable& keys,
                         const std::vector<std::string>& overrides)
{
  std::vector<CaseProblem> problems;
  RawDocument document = parse_document(toml, name, problems);
  // What does not parse would drown its own message in missing keys.
  if (!problems.empty()) throw CaseError(problems);
  for (const std::string& one : overrides) apply_override(document, one, problems);
  CheckedCase checked = check_document(document, keys, problems);
  sort_by_place(problems);
  if (!problems.empty()) throw CaseError(problems);

  CaseFile file;
  file.path_ = name;
  file.folder_ = std::filesystem::path(name).parent_path().string();
  file.sections_ = std::move(checked.sections);
  file.arrays_ = std::move(checked.arrays);
  file.keys_ = keys;
  return file;
}

const CaseTable& CaseFile::section(std::string_view name) const
{
  const auto found = sections_.find(name);
  if (found == sections_.end()) throw std::logic_error(fmt::format("no section '{}' in the key table", name));
  return found->second;
}

const std::vector<CaseTable>& CaseFile::tables(std::string_view name) const
{
  const auto found = arrays_.find(name);
  if (found == arrays_.end()) throw std::logic_error(fmt::format("no array '{}' in the key table", name));
  return found->second;
}

const CaseTable* CaseFile::entry(std::string_view array, std::string_view name) const
{
  for (const CaseTable& table : tables(array))
    if (table.text("name") == name) return &table;
  return nullptr;
}

CaseError CaseFile::locate(const CaseError& error) const
{
  std::vector<CaseProblem> problems = error.problems();
  for (CaseProblem& problem : problems)
    if (problem.file.empty()) locate(problem);
  return CaseError(problems);
}

void CaseFile::locate(CaseProblem& problem) const
{
  problem.file = path_;
  const QuotedKey parts = split_quoted(problem.key);
  const bool is_entry = arrays_.contains(parts.word) && !parts.quoted.empty();
  if (is_entry) problem.key = parts.word + '.' + parts.quoted;
  if (is_entry && !parts.rest.empty()) problem.key += '.' + parts.rest;
  const std::string key = problem.key;

  const auto look_in = [&](const CaseTable& table) {
    const std::string prefix = table.path().empty() ? "" : table.path() + '.';
    if (key == table.path() && !key.empty()) put(problem, table.place(""));
    if (key.starts_with(prefix) && table.knows(key.substr(prefix.size())))
      put(problem, table.place(key.substr(prefix.size())));
    // port "ao": the first entry in which a key of this name holds this text
    const bool holds = !is_entry && problem.line == 0 && !parts.quoted.empty() && table.knows(parts.word) &&
                       table.value(parts.word) == CaseValue(parts.quoted);
    if (!holds) return;
    put(problem, table.place(parts.word));
    problem.key = fmt::format("{}{} = {}", prefix, parts.word, toml_text(parts.quoted));
  };
  for (const auto& [name, table] : sections_) look_in(table);
  for (const auto& [name, tables] : arrays_)
    for (const CaseTable& table : tables) look_in(table);
}

}  // namespace valsalva::casefile
