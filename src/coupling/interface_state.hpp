// What the 3D and the 0D side tell each other at the openings, one entry per opening.
// Flow is positive out of the 3D domain, into the opening's port of the network.
#pragma once

#include <vector>

namespace valsalva::coupling {

/// Flows of the velocity at t_s, and the pressures that the network has at t_s with them.
struct InterfaceState {
  double t_s = 0;
  std::vector<double> pressure_mmHg;
  std::vector<double> flow_ml_s;
};

}  // namespace valsalva::coupling
