// Where the flow turns fast: blocks of cells that a finer level should cover.
#pragma once

#include "ib3d/grid/fields.hpp"
#include "ib3d/grid/refinement.hpp"

namespace valsalva::ib3d {

/// Blocks of 4^3 cells of all levels but the finest that hold a cell with |curl u| > threshold (1/s), each with the
/// number of the next finer level. Ghosts of u must be filled. The same list on every rank. Collective.
std::vector<RefinedRegion> vortical_blocks(const Hierarchy& grid, const CompositeMac& u, double threshold);

}  // namespace valsalva::ib3d
