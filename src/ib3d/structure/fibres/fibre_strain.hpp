// How far a fibre network is strained: e = l/l0 - 1 of its springs (slack tension-only springs count as 0)
// and the distance of tethered nodes from their targets (cm); NaN where a position is. For probes and reports.
#pragma once

#include <span>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// Which springs of a group: in a leaflet the circumferential family is tension-only, the radial two-sided.
enum class SpringFamily { all, tension_only, two_sided };

/// l/l0 - 1.
struct Strain {
  double mean = 0.0;
  double largest = 0.0;
};

/// Mean and largest strain of the springs with both ends in `group`, at positions X (cm); zeros if there are
/// none.
Strain fibre_strain(const FibreNetwork& network, std::span<const Vec3> X, const NodeGroup& group,
                    SpringFamily family = SpringFamily::all);

/// Largest |target - X| over the tethers, cm.
double largest_tether_displacement(const FibreNetwork& network, std::span<const Vec3> X);

}  // namespace valsalva::ib3d
