// The aortic root of the paper's problem as a fibre network: three leaflets hanging from the attachment lines
// of a tethered, three-layered wall with three sinuses. The leaflets start closed, in equilibrium with a few
// mmHg; rows and columns end in nodes tethered to the attachment line. Positions in cm; the tube runs from z
// = 0 to z = length about `centre`. Groups: "leaflet 1" to "leaflet 3" (centred on theta = 0, 120, 240
// degrees; rotations of one another unless their factors differ), then "wall 1", "wall 2", ... from the inside out. Free edges run from
// commissure to commissure, the tethered commissure nodes included. Sources: docs, and Peskin & McQueen 1994
// for the leaflets.
#pragma once

#include <array>
#include <vector>

#include "ib3d/structure/aortic_root/leaflet_equilibrium.hpp"
#include "ib3d/structure/aortic_root/root_parameters.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// Pressure at which the closed valve is judged, mmHg.
inline constexpr double kClosedPressure_mmHg = 85.0;

/// The root as a run starts with it, and the shapes its leaflets were designed for.
struct AorticRoot {
  FibreNetwork network;                       ///< X is the start of the run
  std::vector<std::array<int, 3>> triangles;  ///< the leaflets' surfaces, for areas and pictures
  std::array<LeafletShape, 3> closed;         ///< each leaflet under 85 mmHg
  std::array<LeafletShape, 3> start;          ///< under start_pressure_mmHg
};

/// The root on a grid of spacing h (cm), with what is known of its leaflets' shapes. `factors` of leaflets 1, 2
/// and 3. The dimensions must fit each other and the grid (setup/check_root.cpp); SolverError if a leaflet finds no
/// equilibrium.
AorticRoot design_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                              const WallMaterial& wall, double h,
                              const std::array<LeafletFactors, 3>& factors = {});

/// The network alone.
FibreNetwork build_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                               const WallMaterial& wall, double h);

}  // namespace valsalva::ib3d
