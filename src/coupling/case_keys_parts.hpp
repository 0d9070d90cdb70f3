// The parts of the key table, one file each.
#pragma once

#include <vector>

#include "common/case_key.hpp"

namespace valsalva::coupling {

std::vector<common::KeySection> numerics_sections();   ///< time, domain, grid, fluid, pressure, coupling
std::vector<common::KeySection> structure_sections();  ///< structure, root, leaflets, wall
common::KeySection output_section();
common::KeySection checkpoint_section();
common::KeyArray opening_array();
common::KeyArray refine_array();
common::KeySection surrogate_section();  ///< the numbers of an orifice_valve
common::KeyArray markers_array();
common::KeyArray element_array();  ///< one variant per element type of the lumped layer

common::KeySection fit_section();
std::vector<common::KeyArray> fit_arrays();  ///< fit_parameter, fit_signal, fit_target

}  // namespace valsalva::coupling
