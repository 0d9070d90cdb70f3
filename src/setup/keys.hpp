// All keys of a case, bound to the members of `Case`: the one place where they are named, with unit, range and meaning.
#pragma once

#include <vector>

#include "casefile/bound_key.hpp"
#include "setup/case.hpp"

namespace valsalva::setup {

using Section = casefile::BoundSection<Case>;
using Array = casefile::BoundArray<Case>;

/// In the order of the documentation.
const std::vector<Section>& sections();
const std::vector<Array>& arrays();

/// The keys alone, for checking and printing. Built at the first call.
const casefile::KeyTable& case_keys();

// The parts, one file each.
std::vector<Section> numerics_sections();   ///< time, domain, grid, fluid, pressure, coupling
std::vector<Section> structure_sections();  ///< structure, root, leaflets, wall
Section surrogate_section();                ///< numbers of an orifice_valve
std::vector<Section> output_sections();     ///< output, checkpoint
Section fit_section();
std::vector<Array> flow_arrays();  ///< opening, refine, markers
Array element_array();             ///< one variant per element type of the lumped layer
std::vector<Array> fit_arrays();   ///< fit_parameter, fit_signal, fit_target

}  // namespace valsalva::setup
