#include "casefile/unknown_key.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "common/nearest_name.hpp"

namespace valsalva::casefile {

namespace {

constexpr std::array kUnitWords = {"Pa",  "kPa",  "hPa",  "bar", "mmHg", "cmH2O", "dyn", "kdyn", "N",
                                   "mN",  "um",   "mm",   "cm",  "m",    "us",    "ms",  "s",    "min",
                                   "h",   "ml",   "l",    "L",   "mL",   "cc",    "kg",  "g",    "mg",
                                   "Hz",  "1",    "bpm",  "mPa", "P",    "cP",    "rad", "deg",  "dyne",
                                   "atm", "torr", "inch", "sec", "msec", "hour",  "psi", "J"};

/// "cm3" is the unit word "cm" with a power; "end" is no unit.
bool is_unit_word(std::string word)
{
  const auto known = [&] {
    return std::find(kUnitWords.begin(), kUnitWords.end(), word) != kUnitWords.end();
  };
  if (known()) return true;
  if (word.size() > 1 && std::isdigit(static_cast<unsigned char>(word.back()))) word.pop_back();
  return known();
}

bool is_unit_suffix(std::string_view suffix)
{
  std::size_t begin = 0;
  while (begin <= suffix.size()) {
    const std::size_t end = std::min(suffix.find('_', begin), suffix.size());
    if (!is_unit_word(std::string(suffix.substr(begin, end - begin)))) return false;
    begin = end + 1;
  }
  return true;
}

std::vector<std::string> names_of(const std::vector<Key>& keys)
{
  std::vector<std::string> names;
  for (const Key& key : keys) names.push_back(key.name);
  return names;
}

bool knows(const std::vector<Key>& keys, std::string_view name)
{
  return std::any_of(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
}

}  // namespace

std::string unit_suffix(std::string_view unit)
{
  std::string suffix;
  for (char c : unit) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      suffix += c;
    else if ((c == ' ' || c == '/') && !suffix.empty() && suffix.back() != '_')
      suffix += '_';
  }
  return suffix;
}

const Key* key_with_other_unit(std::string_view name, const std::vector<Key>& keys)
{
  for (const Key& key : keys) {
    const std::string ending = '_' + unit_suffix(key.unit);
    if (key.unit.empty() || !key.name.ends_with(ending)) continue;
    const std::string stem = key.name.substr(0, key.name.size() - ending.size());
    if (name == stem) return &key;
    const bool same_stem =
        name.starts_with(stem) && name.size() > stem.size() + 1 && name[stem.size()] == '_';
    if (same_stem && is_unit_suffix(name.substr(stem.size() + 1))) return &key;
  }
  return nullptr;
}

UnknownKey describe_unknown(std::string_view name, const std::vector<Key>& keys, const std::string& table,
                            const KeyTable& all)
{
  if (const Key* key = key_with_other_unit(name, keys))
    return {"the unit of this key is " + key->unit + "; convert the value and write '" + key->name + "'",
            key->name};
  const std::string nearest = common::nearest_name(name, names_of(keys));
  if (!nearest.empty()) return {"unknown key; did you mean '" + nearest + "'?", nearest};
  for (const KeySection& section : all.sections)
    if (!section.name.empty() && knows(section.keys, name))
      return {"this key belongs in [" + section.name + "]", ""};
  std::string known;
  for (const std::string& key : names_of(keys)) known += (known.empty() ? "" : ", ") + key;
  return {"unknown key; " + table + " knows " + known, ""};
}

}  // namespace valsalva::casefile
