#include "setup/surrogate.hpp"

#include <fmt/format.h>

namespace valsalva::setup {

RootPorts root_ports(const Case& c)
{
  RootPorts ports;
  for (const ib3d::Opening& o : c.openings) {
    const bool is_outlet = ib3d::is_high(o.side);
    (is_outlet ? ports.outlet : ports.inlet) = o.name;
    (is_outlet ? ports.outlet_node : ports.inlet_node) = o.port;
  }
  if (c.openings.size() != 2 || ports.inlet.empty() || ports.outlet.empty())
    throw CaseError(
        "opening",
        fmt::format("appears {} time{}; the 0D surrogate of a root joins one opening on z_lo to one on "
                    "z_hi. Run this case in 3D, or give it these two openings",
                    c.openings.size(), c.openings.size() == 1 ? "" : "s"));
  return ports;
}

lumped::ElementSpec surrogate_element(const Case& c)
{
  const RootPorts ports = root_ports(c);
  lumped::ElementSpec root{kSurrogateName,
                           "orifice_valve",
                           {{"from", ports.inlet_node}, {"to", ports.outlet_node}},
                           c.surrogate,
                           {},
                           {}};
  root.numbers["density_g_cm3"] = c.fluid.density;
  return root;
}

lumped::NetworkSpec lumped_network(const Case& c)
{
  lumped::NetworkSpec spec = c.network;
  if (c.is_lumped()) return spec;
  spec.ports.clear();
  spec.elements.push_back(surrogate_element(c));
  return spec;
}

}  // namespace valsalva::setup
