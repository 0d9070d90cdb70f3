// The markers of a case, [[markers]]: points on a square lattice in discs across the vessel, or in its lumen.
#pragma once

#include <vector>

#include "casefile/case_file.hpp"
#include "ib3d/interaction/markers.hpp"

namespace valsalva::setup {

/// One seed per entry; h is the finest spacing (cm), by which markers of a lumen keep away from the wall. Throws
/// CaseError with every entry that cannot be.
std::vector<ib3d::MarkerSeed> marker_seeds_from_case(const CaseFile& c, const ib3d::Domain& domain, double h);

}  // namespace valsalva::setup
