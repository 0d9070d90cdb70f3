// The key table and a checked case as texts: resolved case, commented template, reference in Markdown.
#include <fmt/format.h>

#include "casefile/case_file.hpp"

namespace valsalva::casefile {

namespace {

std::string remark(const Key& key)
{
  return fmt::format("{} ({})", key.meaning, allowed_text(key));
}

std::string setting_line(const std::string& setting, const Key& key)
{
  return fmt::format("{:<44} # {}{}\n", setting, remark(key), key.required ? "; required" : "");
}

/// `key = value  # meaning`; a key without a default stands as a comment, with a usual value if there is one.
std::string template_line(const Key& key)
{
  const bool absent = std::holds_alternative<std::monostate>(key.otherwise);
  return setting_line((absent ? "# " : "") + key.name + " = " + toml_text(absent ? key.usual : key.otherwise),
                      key);
}

std::string lines_of(const std::vector<Key>& keys)
{
  std::string all;
  for (const Key& key : keys) all += template_line(key);
  return all;
}

std::string lines_of(const CaseTable& table)
{
  std::string all;
  for (const Key& key : table.keys())
    if (table.has(key.name)) all += setting_line(key.name + " = " + toml_text(table.value(key.name)), key);
  return all;
}

std::string commented(const std::string& text)
{
  std::string all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    all += (line.starts_with("# ") ? "" : "# ") + line + "\n";
    begin = end + 1;
  }
  return all;
}

/// A | inside a cell would end it.
std::string cell_text(const std::string& text)
{
  std::string escaped;
  for (char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string no_default(const Key& key)
{
  if (!key.required) return "absent";
  const bool has_example = !std::holds_alternative<std::monostate>(key.usual);
  return has_example ? fmt::format("required, e.g. `{}`", toml_text(key.usual)) : "required";
}

std::string markdown_table(const std::vector<Key>& keys)
{
  std::string all = "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n";
  for (const Key& key : keys) {
    const bool has_default = !std::holds_alternative<std::monostate>(key.otherwise);
    const std::string usual = has_default ? fmt::format("`{}`", toml_text(key.otherwise)) : no_default(key);
    all += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, key.unit, allowed_text(key), usual,
                       cell_text(key.meaning));
  }
  return all + "\n";
}

}  // namespace

std::string CaseFile::resolved_toml() const
{
  std::string all = "# " + path_ + " with all defaults filled in; written by valsalva.\n";
  for (const KeySection& section : keys_.sections) {
    const CaseTable& table = sections_.find(section.name)->second;
    if (!section.name.empty()) all += "\n# " + section.meaning + "\n[" + section.name + "]\n";
    all += lines_of(table);
  }
  for (const KeyArray& array : keys_.arrays)
    for (const CaseTable& entry : tables(array.name)) all += "\n[[" + array.name + "]]\n" + lines_of(entry);
  return all;
}

std::string template_toml(const KeyTable& keys)
{
  std::string all = "# All keys of a case with their defaults. What stands behind a # has no default.\n";
  for (const KeySection& section : keys.sections) {
    if (section.name.empty())
      all += "# extends = \"../base.toml\"  # start from another case; keys given here win\n";
    else
      all += "\n# " + section.meaning + "\n[" + section.name + "]\n";
    all += lines_of(section.keys);
  }
  for (const KeyArray& array : keys.arrays) {
    all += "\n# " + array.meaning + "\n";
    if (array.variants.empty()) all += commented("[[" + array.name + "]]\n" + lines_of(array.keys));
    for (const KeyVariant& variant : array.variants)
      all += "\n# " + variant.meaning + "\n" +
             commented("[[" + array.name + "]]\n" + lines_of(array.keys) + "type = \"" + variant.type +
                       "\"\n" + lines_of(variant.keys));
  }
  return all;
}

std::string keys_markdown(const KeyTable& keys)
{
  std::string all =
      "# Keys of a case\n\nWritten by `valsalva keys --markdown`; a test compares this page with the "
      "program.\n\n"
      "A case is a TOML file. The unit is part of a key's name. `extends = \"../base.toml\"` at the top "
      "starts from "
      "another case: keys given here win, entries of `[[...]]` are merged by their `name`. `--set "
      "section.key=value` "
      "and `--set array.name.key=value` on the command line win over both.\n\n";
  for (const KeySection& section : keys.sections) {
    const std::string header = section.name.empty() ? "At the top" : "`[" + section.name + "]`";
    all += "## " + header + "\n\n" + section.meaning + ".\n\n" + markdown_table(section.keys);
  }
  for (const KeyArray& array : keys.arrays) {
    all += "## `[[" + array.name + "]]`\n\n" + array.meaning + ".\n\n" + markdown_table(array.keys);
    for (const KeyVariant& variant : array.variants)
      all += "### `type = \"" + variant.type + "\"`\n\n" + variant.meaning + ".\n\n" +
             markdown_table(variant.keys);
  }
  all.pop_back();
  return all;
}

}  // namespace valsalva::casefile
