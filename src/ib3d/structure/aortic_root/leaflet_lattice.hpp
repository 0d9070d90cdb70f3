// One leaflet's reference lattice on the tube: coordinates s = R theta and z, rows of constant z (springs of
// the circumferential family), columns of constant s (radial family), bending along both, and edge nodes
// where rows and columns end on the attachment line. The leaflet is centred on theta = 0, the vessel's axis
// is x = y = 0.
//   circumferential  T = Kc w (l/l0 - 1), tension only, w the distance of rows (half on the free edge),
//                    l0 = c(z) x length on the tube, c from circumferential_rest_ratio to
//                    free_edge_rest_ratio
//   radial           T = Kr w (l/l0 - 1), two-sided, w the distance of columns, l0 = radial_rest_ratio x
//   length bending          rigidity = D w per beam (see fibre_network.hpp)
// Rest lengths of interior springs are at most h/2 (both families are longer at rest than on the tube).
// Interior nodes keep more than half a spacing from the attachment line, so no spring is shorter than 0.4 of
// the spacing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ib3d/structure/aortic_root/root_parameters.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

struct LeafletLattice {
  FibreNetwork network;               ///< one leaflet at its place on the tube; edge nodes not tethered
  std::vector<double> s, z;           ///< reference coordinates per node, cm; z from the annulus
  std::vector<std::uint8_t> on_edge;  ///< per node: on the attachment line
  std::vector<std::int8_t>
      fused_to;  ///< per node: -1 fused to the previous leaflet, 1 to the next, 0 to none
  std::vector<std::array<int, 3>> triangles;         ///< surface, normals away from the axis on the tube
  std::vector<int> middle;                           ///< column s = 0 from the free edge down
  double row_distance = 0.0, column_distance = 0.0;  ///< cm
};

/// The lattice of one leaflet on a grid of spacing h (cm).
LeafletLattice leaflet_lattice(const RootDimensions& root, const LeafletMaterial& material, double h);

}  // namespace valsalva::ib3d
