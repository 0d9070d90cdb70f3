#include "lumped/network/complete_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/nearest_name.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

namespace {

std::string with_unit(double value, const ElementParameter& p)
{
  return p.unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, p.unit);
}

std::string allowed(const ElementParameter& p)
{
  const std::string low =
      std::isinf(p.lowest) ? "" : fmt::format("{} {}", p.lowest_excluded ? "above" : "at least", p.lowest);
  const std::string high = std::isinf(p.highest) ? "" : fmt::format("at most {}", p.highest);
  if (low.empty() && high.empty()) return "a finite number";
  return low + (low.empty() || high.empty() ? "" : " and ") + high;
}

std::string advice(const ElementParameter& p)
{
  if (p.usual) return fmt::format(" A usual adult value is {}.", *p.usual);
  if (p.default_number) return fmt::format(" The default is {}.", *p.default_number);
  return "";
}

/// Checks one element and fills in its defaults.
class ElementCheck {
 public:
  ElementCheck(ElementSpec& element, const ElementType& type, std::vector<CaseProblem>& problems)
      : element_(element), type_(type), problems_(problems), before_(problems.size())
  {
  }

  void run(double period_s)
  {
    check_terminals();
    check_unknown(element_.numbers);
    check_unknown(element_.lists);
    check_unknown(element_.words);
    for (const ElementParameter& p : type_.parameters) {
      if (p.kind == ParameterKind::number) check_number(p);
      if (p.kind == ParameterKind::list) check_list(p);
      if (p.kind == ParameterKind::word) check_word(p);
    }
    if (problems_.size() == before_ && type_.check) type_.check(element_, period_s, problems_);
  }

 private:
  void report(const std::string& key, const std::string& message)
  {
    problems_.push_back({"", 0, 0, element_key(element_, key), message});
  }

  void check_terminals()
  {
    for (const std::string& terminal : type_.terminals) {
      const auto found = element_.nodes.find(terminal);
      if (found == element_.nodes.end() || found->second.empty())
        report(terminal,
               fmt::format("is missing; a {} is joined to the network by {}. Give the name of a node.",
                           type_.name, fmt::join(type_.terminals, " and ")));
    }
    for (const auto& [terminal, node] : element_.nodes)
      if (std::find(type_.terminals.begin(), type_.terminals.end(), terminal) == type_.terminals.end())
        report(terminal, fmt::format("is not a terminal of a {}, which has {}. Leave it out.", type_.name,
                                     fmt::join(type_.terminals, " and ")));
    if (type_.terminals.size() == 2 && element_.nodes.count("from") && element_.nodes.count("to") &&
        element_.nodes["from"] == element_.nodes["to"])
      report("to", fmt::format("is the node \"{}\", as is from; an element needs two different nodes.",
                               element_.nodes["to"]));
  }

  template <class Map>
  void check_unknown(const Map& given)
  {
    std::vector<std::string> known;
    for (const ElementParameter& p : type_.parameters) known.push_back(p.name);
    for (const auto& entry : given)
      if (std::find(known.begin(), known.end(), entry.first) == known.end())
        report(entry.first, fmt::format("is not a parameter of a {}{}. It has {}.", type_.name,
                                        common::did_you_mean(entry.first, known), fmt::join(known, ", ")));
  }

  void report_missing(const ElementParameter& p)
  {
    report(p.name, fmt::format("is missing; a {} needs it ({}{}{}).{}", type_.name, p.meaning,
                               p.unit.empty() ? "" : ", ", p.unit, advice(p)));
  }

  void check_range(const ElementParameter& p, double value)
  {
    const bool above = p.lowest_excluded ? value > p.lowest : value >= p.lowest;
    if (std::isfinite(value) && above && value <= p.highest) return;
    report(p.name,
           fmt::format("is {}; {} must be {}.{}", with_unit(value, p), p.quantity, allowed(p), advice(p)));
  }

  void check_number(const ElementParameter& p)
  {
    if (element_.lists.count(p.name) || element_.words.count(p.name)) {
      report(p.name, fmt::format("is not a number; {} is one number{}{}.{}", p.quantity,
                                 p.unit.empty() ? "" : " in ", p.unit, advice(p)));
      return;
    }
    const auto found = element_.numbers.find(p.name);
    if (found != element_.numbers.end())
      check_range(p, found->second);
    else if (p.default_number)
      element_.numbers[p.name] = *p.default_number;
    else if (p.required)
      report_missing(p);
  }

  void check_list(const ElementParameter& p)
  {
    if (const auto one = element_.numbers.find(p.name); one != element_.numbers.end()) {
      element_.lists[p.name] = {one->second};
      element_.numbers.erase(one);
    }
    if (element_.words.count(p.name)) {
      report(p.name, "is a word; it must be a number or a list of numbers.");
      return;
    }
    const auto found = element_.lists.find(p.name);
    if (found == element_.lists.end() || found->second.empty()) {
      if (p.required) report_missing(p);
      return;
    }
    for (double value : found->second) check_range(p, value);
  }

  void check_word(const ElementParameter& p)
  {
    const auto found = element_.words.find(p.name);
    if (element_.numbers.count(p.name) || element_.lists.count(p.name))
      report(p.name, fmt::format("is a number; {} is {}.", p.quantity, common::one_of(p.choices)));
    else if (found == element_.words.end())
      p.default_word.empty() && p.required ? report_missing(p) : fill_in_word(p);
    else if (!p.choices.empty() &&
             std::find(p.choices.begin(), p.choices.end(), found->second) == p.choices.end())
      report(p.name, fmt::format("is \"{}\"; {} is {}{}.", found->second, p.quantity,
                                 common::one_of(p.choices), common::did_you_mean(found->second, p.choices)));
  }

  void fill_in_word(const ElementParameter& p)
  {
    if (!p.default_word.empty()) element_.words[p.name] = p.default_word;
  }

  ElementSpec& element_;
  const ElementType& type_;
  std::vector<CaseProblem>& problems_;
  std::size_t before_;
};

}  // namespace

NetworkSpec complete_spec(NetworkSpec spec)
{
  std::vector<CaseProblem> problems;
  std::vector<std::string> types;
  for (const ElementType& type : element_types()) types.push_back(type.name);
  std::set<std::string> names;
  for (ElementSpec& element : spec.elements) {
    if (!names.insert(element.name).second)
      problems.push_back(
          {"", 0, 0, element_key(element), "is there twice; every element needs a name of its own."});
    const ElementType* type = find_element_type(element.type);
    if (!type) {
      problems.push_back({"", 0, 0, element_key(element, "type"),
                          fmt::format("is \"{}\"{}. The types are {}.", element.type,
                                      common::did_you_mean(element.type, types), fmt::join(types, ", "))});
      continue;
    }
    ElementCheck(element, *type, problems).run(spec.period_s);
  }
  if (!problems.empty()) throw CaseError(std::move(problems));
  return spec;
}

}  // namespace valsalva::lumped
