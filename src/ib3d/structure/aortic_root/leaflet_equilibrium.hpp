// Form-finding: the shape in which one closed leaflet carries a pressure. At every node off the attachment
// line
//   F_elastic(X) - p A(X) + F_contact(X) = 0,
// A the node's share of the area vectors of its triangles (cm^2, away from the axis before the leaflet
// closes); edge nodes stay where they are. The neighbouring leaflets are the two planes theta = +-60 degrees
// through the axis: closer than a gap of 0.025 cm a node is pushed back with 5e7 dyn/cm^3 x its reference
// area x depth; a node fused to its neighbour is held at the gap from both sides. Solved by damped relaxation with the FIRE rule (Bitzek et al., Phys. Rev. Lett. 97 (2006)
// 170201) on fictitious masses that bound the stiffness, so that the time step needs no tuning.
// Deterministic, one core.
#pragma once

#include <span>
#include <vector>

#include "ib3d/structure/aortic_root/leaflet_lattice.hpp"

namespace valsalva::ib3d {

/// What a closed leaflet looks like, for reports. Strains and tensions count slack fibres as 0.
struct LeafletShape {
  double pressure_mmHg = 0.0;
  double circumferential_strain_mean = 0.0, circumferential_strain_max = 0.0;
  double radial_strain_mean = 0.0, radial_strain_max = 0.0;
  double tension_mean = 0.0, tension_max = 0.0;  ///< circumferential, dyn/cm
  double coaptation_height_cm = 0.0;             ///< of the middle, within 1 mm of the neighbours' middles
  double contact_area_cm2 = 0.0;                 ///< of one leaflet, pressed on its neighbours, at rest
  double free_edge_length_cm = 0.0,
         middle_length_cm = 0.0;  ///< from commissure to commissure; free edge to attachment
  double residual = 0.0;          ///< rms nodal force / rms nodal pressure force
  int iterations = 0;
};

struct LeafletEquilibrium {
  std::vector<Vec3> X;  ///< per lattice node, cm
  LeafletShape shape;
};

/// The residual at which a shape counts as an equilibrium.
inline constexpr double kEquilibriumResidual = 5e-5;

/// A closed position of the lattice to begin from: the free edge straight from the commissures to the axis.
std::vector<Vec3> closed_leaflet_guess(const RootDimensions& root, const LeafletLattice& lattice);

/// Equilibrium under `pressure_mmHg` from the positions `guess`. SolverError if it is not reached.
LeafletEquilibrium find_leaflet_equilibrium(const LeafletLattice& lattice, const LeafletMaterial& material,
                                            double pressure_mmHg, std::span<const Vec3> guess);

/// Force (dyn per node, edge nodes included) of pressure (dyn/cm^2) and of the neighbours at X; what the
/// attachment must bear is this plus the elastic force.
void leaflet_load(const LeafletLattice& lattice, double pressure, std::span<const Vec3> X, std::span<Vec3> F);

}  // namespace valsalva::ib3d
