
#include "lumped/network/element_types.hpp"
#include "setup/keys.hpp"

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

std::string terminal_meaning(const lumped::ElementType& type, const std::string& terminal)
{
  if (type.terminals.size() == 1) return "Node the element is joined to";
  return std::string("Node at the element's ") + (terminal == "from" ? "inlet" : "outlet");
}

KeyVariant variant_of(const lumped::ElementType& type)
{
  KeyVariant variant{type.name, type.meaning, {}};
  for (const std::string& terminal : type.terminals)
    variant.keys.push_back(text(terminal, terminal_meaning(type, terminal)));
  for (const lumped::ElementParameter& parameter : type.parameters) variant.keys.push_back(key_of(parameter));
  return variant;
}

lumped::ElementSpec element_of(const CaseTable& table)
{
  lumped::ElementSpec element;
  element.name = table.text("name");
  element.type = table.text("type");
  const lumped::ElementType* type = lumped::find_element_type(element.type);
  for (const std::string& terminal : type->terminals) element.nodes[terminal] = table.text(terminal);
  for (const lumped::ElementParameter& p : type->parameters) {
    if (!table.has(p.name)) continue;
    switch (p.kind) {
      case lumped::ParameterKind::number:
        element.numbers[p.name] = table.real(p.name);
        break;
      case lumped::ParameterKind::list:
        element.lists[p.name] = table.reals(p.name);
        break;
      case lumped::ParameterKind::word:
        element.words[p.name] = table.text(p.name);
        break;
    }
  }
  return element;
}

}  // namespace

Section surrogate_section()
{
  BoundKeys<Case> keys;
  for (const lumped::ElementParameter& p : lumped::find_element_type("orifice_valve")->parameters)
    if (Case{}.surrogate.contains(p.name))  // the density is that of [fluid]
      keys.emplace_back(
          key_of(p), [=](const Case& c) { return CaseValue(c.surrogate.at(p.name)); },
          [=](Case& c, const CaseValue& value) { c.surrogate.at(p.name) = std::get<double>(value); });
  return bound_section<Case, Case>(
      "surrogate",
      "The 0D element that stands for the 3D root in `run --lumped` and `time.start = \"periodic\"`; "
      "see `valsalva calibrate`",
      std::identity{}, keys);
}

Array element_array()
{
  KeyArray array{"element",
                 "An element of the lumped network; elements meet at nodes of the same name",
                 {text("name", "Unique name of the element")},
                 {}};
  for (const lumped::ElementType& type : lumped::element_types()) array.variants.push_back(variant_of(type));
  return {array, [](Case& c, const std::vector<CaseTable>& tables) {
            for (const CaseTable& table : tables) c.network.elements.push_back(element_of(table));
          }};
}

}  // namespace valsalva::setup
