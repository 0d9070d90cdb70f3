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
common::KeyArray element_array();  ///< one variant per element type of the lumped layer

}  // namespace valsalva::coupling
