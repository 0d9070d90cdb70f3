// A fused commissure: two neighbouring leaflets grown together along their free edges, from the commissure
// towards their middles, as in rheumatic and bicuspid valves. Every node of leaflet a in that part of the free
// edge, and below it every node that lies within 1 mm of its mirror image on leaflet b, is joined to it by a
// two-sided spring that is slack where the run starts,
//   T = k (l - l0),   k = Kc x row distance / column distance   (dyn/cm, that of a spring of the rows),
// so that joining does not shorten the stable step.
#pragma once

#include "ib3d/structure/fiber_network.hpp"
#include "ib3d/structure/leaflet_lattice.hpp"

namespace valsalva::ib3d {

/// Joins the side s >= s_from (cm) of leaflet a to the side s <= -s_from of leaflet b. Nodes of the lattices
/// stand in `network` from first_a and first_b on. Kc (dyn/cm) is the stiffness of the circumferential family.
void fuse_leaflets(const LeafletLattice& a, int first_a, const LeafletLattice& b, int first_b, double s_from,
                   double Kc, FiberNetwork& network);

}  // namespace valsalva::ib3d
