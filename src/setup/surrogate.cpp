#include "setup/surrogate.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "setup/network_from_case.hpp"

namespace valsalva::setup {

RootPorts root_ports(const CaseFile& c)
{
  const std::vector<CaseTable>& openings = c.tables("opening");
  RootPorts ports;
  for (const CaseTable& o : openings) {
    const bool is_inlet = o.text("side") == "z_lo";
    (is_inlet ? ports.inlet : ports.outlet) = o.text("name");
    (is_inlet ? ports.inlet_node : ports.outlet_node) = o.text("port");
  }
  if (openings.size() != 2 || ports.inlet.empty() || ports.outlet.empty())
    throw CaseError(
        "opening",
        fmt::format("is there {} time{}; the 0D surrogate of a root joins one opening on z_lo to one on "
                    "z_hi. Run this case in 3D, or give it these two openings.",
                    openings.size(), openings.size() == 1 ? "" : "s"));
  return ports;
}

lumped::ElementSpec surrogate_element(const CaseFile& c)
{
  const RootPorts ports = root_ports(c);
  lumped::ElementSpec root{
      kSurrogateName, "orifice_valve", {{"from", ports.inlet_node}, {"to", ports.outlet_node}}, {}, {}, {}};
  const CaseTable& keys = c.section("surrogate");
  for (const casefile::Key& key : keys.keys()) root.numbers[key.name] = keys.real(key.name);
  root.numbers["density_g_cm3"] = c.section("fluid").real("density_g_cm3");
  return root;
}

lumped::NetworkSpec lumped_network_from_case(const CaseFile& c)
{
  lumped::NetworkSpec spec = network_from_case(c);
  if (spec.ports.empty()) return spec;
  spec.ports.clear();
  spec.elements.push_back(surrogate_element(c));
  return spec;
}

}  // namespace valsalva::setup
