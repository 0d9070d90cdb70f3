// Which observables of a 0D network play the part of the aortic valve's flow and of the pressures beside it.
#pragma once

#include <string>

#include "lumped/network/network_spec.hpp"

namespace valsalva::setup {

/// Names of observables.
struct AorticValve {
  std::string flow, p_ventricle,
      p_aorta;  ///< "Q_aortic_ml_s", "p_lv_mmHg", "p_ao_mmHg"; empty without valves
};

/// The surrogate of a 3D root; else the first valve from a chamber to a node without a chamber; else the first.
AorticValve find_aortic_valve(const lumped::NetworkSpec& spec);

}  // namespace valsalva::setup
