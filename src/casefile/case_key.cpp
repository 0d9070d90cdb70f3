#include "casefile/case_key.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/nearest_name.hpp"

namespace valsalva::casefile {

namespace {

template <class Change>
Key changed(Key key, Change change)
{
  change(key);
  return key;
}

Key with_default(const Key& key, CaseValue value)
{
  return changed(key, [&](Key& k) { k.otherwise = std::move(value), k.required = false; });
}

Key new_key(KeyKind kind, std::string name, std::string unit, std::string meaning)
{
  Key key;
  key.kind = kind;
  key.name = std::move(name);
  key.unit = std::move(unit);
  key.meaning = std::move(meaning);
  return key;
}

}  // namespace

Key Key::in(double low, double high) const
{
  return changed(*this, [&](Key& k) { k.lowest = low, k.highest = high; });
}
Key Key::at_least(double low) const
{
  return changed(*this, [&](Key& k) { k.lowest = low; });
}
Key Key::above(double low) const
{
  return changed(*this, [&](Key& k) { k.lowest = low, k.lowest_excluded = true; });
}
Key Key::of_count(std::size_t numbers) const
{
  return changed(*this, [&](Key& k) { k.count = numbers; });
}
Key Key::optional() const
{
  return changed(*this, [](Key& k) { k.required = false; });
}
Key Key::or_else(double value) const
{
  if (kind == KeyKind::integer) return with_default(*this, std::lround(value));
  return with_default(*this, value);
}
Key Key::or_else(int value) const
{
  return or_else(static_cast<double>(value));
}
Key Key::or_else(const char* value) const
{
  return with_default(*this, std::string(value));
}
Key Key::or_else(bool value) const
{
  return with_default(*this, value);
}
Key Key::or_else(std::vector<double> value) const
{
  return with_default(*this, std::move(value));
}
Key Key::example(double value) const
{
  return changed(*this, [&](Key& k) { k.usual = value; });
}

Key real(std::string name, std::string unit, std::string meaning)
{
  return new_key(KeyKind::real, std::move(name), std::move(unit), std::move(meaning));
}
Key integer(std::string name, std::string meaning)
{
  return new_key(KeyKind::integer, std::move(name), "", std::move(meaning));
}
Key flag(std::string name, std::string meaning)
{
  return new_key(KeyKind::flag, std::move(name), "", std::move(meaning));
}
Key text(std::string name, std::string meaning)
{
  return new_key(KeyKind::text, std::move(name), "", std::move(meaning));
}
Key choice(std::string name, std::vector<std::string> choices, std::string meaning)
{
  Key key = new_key(KeyKind::choice, std::move(name), "", std::move(meaning));
  key.choices = std::move(choices);
  return key;
}
Key reals(std::string name, std::string unit, std::string meaning)
{
  return new_key(KeyKind::reals, std::move(name), std::move(unit), std::move(meaning));
}

const KeySection* KeyTable::find_section(std::string_view name) const
{
  for (const KeySection& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

const KeyArray* KeyTable::find_array(std::string_view name) const
{
  for (const KeyArray& array : arrays)
    if (array.name == name) return &array;
  return nullptr;
}

std::string allowed_text(const Key& key)
{
  if (key.kind == KeyKind::flag) return "true or false";
  if (key.kind == KeyKind::text) return "a text in quotes";
  if (key.kind == KeyKind::choice) return common::one_of(key.choices);
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  std::string range;
  const bool low = std::isfinite(key.lowest), high = std::isfinite(key.highest);
  if (low && high)
    range = fmt::format("from {} to {}{}", key.lowest, key.highest, unit);
  else if (low)
    range = fmt::format("{} {}{}", key.lowest_excluded ? "above" : "of at least", key.lowest, unit);
  else if (high)
    range = fmt::format("of at most {}{}", key.highest, unit);
  std::string what = key.kind == KeyKind::integer ? "a whole number" : "a number";
  if (key.kind == KeyKind::reals)
    what = key.count > 0 ? fmt::format("{} numbers", key.count) : "a list of numbers";
  if (range.empty()) return what + (unit.empty() ? "" : " in" + unit);
  return what + " " + range;
}

std::string toml_text(const CaseValue& value)
{
  struct Writer {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(double x) const
    {
      std::string digits = fmt::format("{}", x);
      return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
    }
    std::string operator()(long n) const { return fmt::format("{}", n); }
    std::string operator()(bool on) const { return on ? "true" : "false"; }
    std::string operator()(const std::string& words) const
    {
      std::string quoted = "\"";
      for (char c : words) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (c == '\n')
          quoted += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20)
          quoted += fmt::format("\\u{:04X}", static_cast<int>(c));
        else
          quoted += c;
      }
      return quoted + '"';
    }
    std::string operator()(const std::vector<double>& list) const
    {
      std::string all = "[";
      for (std::size_t i = 0; i < list.size(); ++i) all += (i > 0 ? ", " : "") + (*this)(list[i]);
      return all + "]";
    }
  };
  return std::visit(Writer{}, value);
}

std::string range_problem(const Key& key, const CaseValue& value)
{
  const auto refused = [&](const std::string& found) {
    return fmt::format("found {}, allowed is {}", found, allowed_text(key));
  };
  const auto outside = [&](double x) {
    return !std::isfinite(x) || x > key.highest || (key.lowest_excluded ? x <= key.lowest : x < key.lowest);
  };
  if (const auto* x = std::get_if<double>(&value); x && outside(*x)) return refused(toml_text(value));
  if (const auto* n = std::get_if<long>(&value); n && outside(static_cast<double>(*n)))
    return refused(toml_text(value));
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    if (key.count > 0 && list->size() != key.count)
      return refused(fmt::format("{} in the list", list->size()));
    if (list->empty()) return refused("an empty list");
    for (double x : *list)
      if (outside(x)) return refused(toml_text(x) + " in the list");
  }
  if (const auto* word = std::get_if<std::string>(&value); word && key.kind == KeyKind::choice) {
    for (const std::string& known : key.choices)
      if (*word == known) return "";
    return refused(toml_text(value)) + common::did_you_mean(*word, key.choices);
  }
  return "";
}

}  // namespace valsalva::casefile
