// The markers of a case, [[markers]]: points on a square lattice in discs across the vessel, or in its lumen.
#pragma once

#include <vector>

#include "ib3d/interaction/markers.hpp"
#include "setup/case.hpp"

namespace valsalva::setup {

/// Groups whose planes or discs leave the box, or whose times are over before they begin.
std::vector<CaseProblem> marker_problems(const Case& c);

/// One seed per group of a case without such problems. Markers of a lumen keep a cell away from the wall.
std::vector<ib3d::MarkerSeed> marker_seeds(const Case& c);

}  // namespace valsalva::setup
