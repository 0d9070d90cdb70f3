#include "lumped/network/element_types.hpp"

#include "lumped/elements/chamber.hpp"
#include "lumped/elements/flow_source.hpp"
#include "lumped/elements/orifice_valve.hpp"
#include "lumped/elements/pressure_source.hpp"
#include "lumped/elements/valve.hpp"
#include "lumped/elements/vessel.hpp"
#include "lumped/elements/windkessel.hpp"

namespace valsalva::lumped {

const std::vector<ElementType>& element_types()
{
  static const std::vector<ElementType> types = {
      windkessel3_type(), windkessel4_type(),   vessel_type(),          chamber_type(),
      valve_type(),       orifice_valve_type(), pressure_source_type(), flow_source_type()};
  return types;
}

const ElementType* find_element_type(const std::string& name)
{
  for (const ElementType& type : element_types())
    if (type.name == name) return &type;
  return nullptr;
}

std::string element_key(const ElementSpec& element, const std::string& parameter)
{
  const std::string key = "element \"" + element.name + "\"";
  return parameter.empty() ? key : key + ": " + parameter;
}

}  // namespace valsalva::lumped
