// The 0D surrogate of the 3D root: one orifice_valve between the nodes of its two openings,
//     (L + rho l/A) dQ/dt = p_inlet - p_outlet - R Q - rho/(2 A^2) Q|Q|,     A = A(leaflet opening zeta).
// Its numbers are the keys of [surrogate], its density is fluid.density_g_cm3. The defaults come from a 3D run
// of cases/aortic_root at h = 10/96 (docs/use/surrogate.md). mmHg, ml, s.
#pragma once

#include <string>

#include "setup/case.hpp"

namespace valsalva::setup {

/// Name of the surrogate among the elements: "Q_aortic_root_ml_s".
inline constexpr const char* kSurrogateName = "aortic_root";

/// The two openings that blood enters and leaves by.
struct RootPorts {
  std::string inlet, outlet;            ///< names of the openings
  std::string inlet_node, outlet_node;  ///< their nodes in the network
};

/// CaseError unless there is one opening on z_lo and one on z_hi.
RootPorts root_ports(const Case& c);

/// CaseError as `root_ports`.
lumped::ElementSpec surrogate_element(const Case& c);

/// The case as a 0D network: its elements and, in place of the 3D root, the surrogate; no ports. A case without
/// openings is that already. CaseError as `root_ports`.
lumped::NetworkSpec lumped_network(const Case& c);

}  // namespace valsalva::setup
