// Where the flow turns fast: cells that a finer level should cover.
#pragma once

#include "ib3d/grid/fields.hpp"
#include "ib3d/grid/refinement.hpp"

namespace valsalva::ib3d {

/// The cells with |curl u| > threshold (1/s) of all levels but the finest, as boxes: one about those of each block of 4^3
/// cells, with the number of the next finer level. u in cm/s, its ghosts filled. The same list on every rank. Collective.
std::vector<RefinedRegion> vortical_blocks(const Hierarchy& grid, const CompositeMac& u, double threshold);

}  // namespace valsalva::ib3d
