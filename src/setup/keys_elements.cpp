#include <map>

#include "lumped/network/element_types.hpp"
#include "setup/keys_parts.hpp"

namespace valsalva::setup {

using namespace casefile;

namespace {

Key key_of_kind(const lumped::ElementParameter& p)
{
  switch (p.kind) {
    case lumped::ParameterKind::number:
      return real(p.name, p.unit, p.meaning);
    case lumped::ParameterKind::list:
      return reals(p.name, p.unit, p.meaning);
    case lumped::ParameterKind::word:
      break;
  }
  return p.choices.empty() ? text(p.name, p.meaning) : choice(p.name, p.choices, p.meaning);
}

Key key_of(const lumped::ElementParameter& p)
{
  Key key = key_of_kind(p);
  key.lowest = p.lowest;
  key.highest = p.highest;
  key.lowest_excluded = p.lowest_excluded;
  if (p.usual) key = key.example(*p.usual);
  // A default makes a parameter optional, whatever `required` says.
  if (!p.default_word.empty()) return key.or_else(p.default_word.c_str());
  if (p.default_number)
    return p.kind == lumped::ParameterKind::list ? key.or_else(std::vector{*p.default_number})
                                                 : key.or_else(*p.default_number);
  return p.required ? key : key.optional();
}

}  // namespace

KeySection surrogate_section()
{
  // From the 3D run of cases/aortic_root at h = 10/96 (docs/use/surrogate.md); the closed orifice hardly leaks.
  const std::map<std::string, double> calibrated{{"area_open_cm2", 3.1},     {"area_closed_cm2", 1e-3},
                                                 {"length_cm", 1.0},         {"opening_1_mmHg_s", 44.0},
                                                 {"closing_1_mmHg_s", 2.95}, {"R_mmHg_s_ml", 0.0},
                                                 {"L_mmHg_s2_ml", 0.0027}};
  KeySection section{
      "surrogate",
      "The 0D element that stands for the 3D root in `run --lumped` and `time.start = \"periodic\"`; "
      "see `valsalva calibrate`",
      {}};
  for (lumped::ElementParameter p : lumped::find_element_type("orifice_valve")->parameters) {
    const auto value = calibrated.find(p.name);
    if (value == calibrated.end()) continue;  // the density is that of [fluid]
    p.default_number = value->second;
    section.keys.push_back(key_of(p));
  }
  return section;
}

KeyArray element_array()
{
  KeyArray array{"element",
                 "An element of the lumped network; elements meet at nodes of the same name",
                 {text("name", "Unique name of the element")},
                 {}};
  for (const lumped::ElementType& type : lumped::element_types()) {
    std::vector<Key> keys;
    for (const std::string& terminal : type.terminals) {
      const bool only_one = type.terminals.size() == 1;
      keys.push_back(text(terminal, only_one ? "Node the element is joined to"
                                             : "Node at the element's " +
                                                   std::string(terminal == "from" ? "inlet" : "outlet")));
    }
    for (const lumped::ElementParameter& parameter : type.parameters) keys.push_back(key_of(parameter));
    array.variants.push_back({type.name, type.meaning, keys});
  }
  return array;
}

}  // namespace valsalva::setup
