// The wall of the aortic root as tethered nodes, in layers half a grid spacing apart along the radius, the
// first on the inner surface; one layer alone leaks through the smeared delta function. Rows of constant z
// carry evenly spaced angles, their number a multiple of three, so that the wall keeps its three-fold
// symmetry. Tether stiffness (dyn/cm) = wall stiffness (dyn/cm^3) x the node's share of its layer's area
// (cm^2).
#pragma once

#include <vector>

#include "ib3d/structure/aortic_root/root_parameters.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// Nodes of one layer and their areas.
struct WallLayer {
  std::vector<Vec3> X;       ///< cm
  std::vector<double> area;  ///< cm^2, their sum is the layer's area
};

/// The layer `offset` cm outside the inner surface, neighbours at most `spacing` cm apart, h the grid spacing
/// (cm, for the flare of the ends).
WallLayer wall_layer(const RootDimensions& root, double h, double offset, double spacing);

/// Appends all layers as groups "wall 1", "wall 2", ... (1 is the innermost).
void add_wall(const RootDimensions& root, const WallMaterial& material, double h, FibreNetwork& network);

}  // namespace valsalva::ib3d
