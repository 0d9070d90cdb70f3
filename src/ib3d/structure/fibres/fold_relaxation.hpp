// Slip of the nodes through the fluid that flattens folds too sharp for the grid. Nodes are h/2 apart: forces that
// alternate every node or two cancel when they are spread, and neighbours move with one velocity, so that the fluid
// neither resists such a fold nor opens it again. Here it flattens itself:
//   V_n = F_n/(time Lambda_n)   [cm/s],    F = -dE/dX,    Lambda_n = sum_m |K_nm|
//   E = sum_beams c (|turn| - turn0)^2/(l1 + l2) where |turn| > turn0,    turn = (X2 - X1)/l2 - (X1 - X0)/l1
// with K the stiffness of E for turn0 = 0, the beams' own bending energy: no fold decays faster than 1/time (Gershgorin),
// one that alternates from node to node on an even lattice just so. At spacing h/2, |turn| is h/2 over the radius of
// curvature: finer grids meet turn0 = 0.4 less often. What bends less does not slip, nor do tethered nodes.
#pragma once

#include <span>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// turn0: 23 degrees from node to node, a radius of curvature of 1.25 h.
constexpr double kSharpestTurn = 0.4;

/// Adds the slip velocities (cm/s, one per node) at the positions X (cm, one per node) to U; `time` > 0 in s. Steps of up
/// to `time` overshoot in no mode. With a rank's part of a network: exact at the owned nodes.
void add_fold_slip(const FibreNetwork& network, std::span<const Vec3> X, double time, std::span<Vec3> U);

}  // namespace valsalva::ib3d
