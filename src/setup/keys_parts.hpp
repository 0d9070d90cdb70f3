// The parts of the key table, one file each.
#pragma once

#include <vector>

#include "casefile/case_key.hpp"

namespace valsalva::setup {

std::vector<casefile::KeySection> numerics_sections();   ///< time, domain, grid, fluid, pressure, coupling
std::vector<casefile::KeySection> structure_sections();  ///< structure, root, leaflets, wall
casefile::KeySection output_section();
casefile::KeySection checkpoint_section();
casefile::KeyArray opening_array();
casefile::KeyArray refine_array();
casefile::KeySection surrogate_section();  ///< the numbers of an orifice_valve
casefile::KeyArray markers_array();
casefile::KeyArray element_array();  ///< one variant per element type of the lumped layer

casefile::KeySection fit_section();
std::vector<casefile::KeyArray> fit_arrays();  ///< fit_parameter, fit_signal, fit_target

}  // namespace valsalva::setup
