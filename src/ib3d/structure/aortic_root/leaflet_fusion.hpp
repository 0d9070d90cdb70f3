// A fused commissure: two neighbouring leaflets joined, as in rheumatic and bicuspid valves, along a
// share of the half free edge from the commissure towards the middle and down to a quarter of the commissure
// height below it. In form-finding both leaflets are held beside the plane between them there; in the run every
// such node of a leaflet is joined to its mirror image on the next by a two-sided spring,
//   T = k (l - l0),   k = Kc x row distance / column distance   (dyn/cm, that of a spring of the rows),
// l0 their distance at the start: joining does not shorten the stable step.
#pragma once

#include "ib3d/structure/aortic_root/leaflet_lattice.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// Marks the nodes that are fused to the neighbours (`fused_to`); shares from 0 to 1 of half the free edge.
void mark_fused(const RootDimensions& root, double share_with_previous, double share_with_next,
                LeafletLattice& lattice);

/// Joins the marked nodes of a leaflet to the next one. Their lattices' nodes stand in `network` from
/// first_node and first_node_of_next on. Kc (dyn/cm) is the stiffness of the circumferential family.
void fuse_leaflets(const LeafletLattice& leaflet, int first_node, const LeafletLattice& next,
                   int first_node_of_next, double Kc, FibreNetwork& network);

}  // namespace valsalva::ib3d
