// What an aortic root is made of: its dimensions (cm), the stiffness of its leaflets and wall, and how single leaflets
// differ from the common material. The defaults are adult dimensions: a tube of radius 1.15 cm with three sinuses. z runs
// along the vessel from the ventricle (z = 0) to the ascending aorta (z = length).
#pragma once

namespace valsalva::ib3d {

struct RootDimensions {
  double annulus_radius = 1.15;      ///< inner radius of the tube up to the commissures, cm
  double annulus_z = 3.2;            ///< lowest points of the attachment lines, cm
  double commissure_height = 1.58;   ///< commissures above the annulus, cm
  double sinus_end_z = 5.3;          ///< sinotubular junction, cm
  double sinus_bulge = 0.52;         ///< largest depth of a sinus beyond the tube, cm
  double ascending_radius = 1.30;    ///< inner radius of the ascending aorta, cm
  double end_flare_spacings = 1.75;  ///< widening of both ends over their last centimetre, in grid spacings
  double centre[2] = {2.5, 2.5};     ///< axis of the vessel, cm
  double length = 15.0;              ///< of the tube, from z = 0; the domain's length in z, cm
};

struct LeafletMaterial {
  double circumferential_stiffness = 1.0e6;  ///< tension-only family from commissure to commissure, dyn/cm
  double radial_stiffness = 1.5e5;           ///< two-sided family from attachment to free edge, dyn/cm
  double circumferential_bending = 100.0;    ///< dyn cm
  double radial_bending = 200.0;             ///< dyn cm
  double circumferential_rest_ratio = 0.97;  ///< rest length over length on the tube, lower part
  double free_edge_rest_ratio = 1.06;        ///< the same at the free edge
  double radial_rest_ratio = 1.10;           ///< the same of the radial family
  double edge_tether_ratio = 8.0;            ///< edge tether = ratio * wall stiffness * (h/2)^2
  double start_pressure_mmHg = 3.0;          ///< the run starts from the equilibrium under this pressure
};

/// How one leaflet differs from the common LeafletMaterial; as they stand, not at all.
struct LeafletFactors {
  double stiffness = 1.0;    ///< of both fibre families
  double bending = 1.0;      ///< of both bending rigidities
  double height = 1.0;       ///< of the radial rest ratio
  double free_edge = 1.0;    ///< of the free edge's rest ratio
  double fused_share = 0.0;  ///< of half the free edge, starting at the commissure, fused to the next leaflet
  bool operator==(const LeafletFactors&) const = default;
};

/// The material of a leaflet with these factors.
LeafletMaterial scaled(const LeafletMaterial& common, const LeafletFactors& factors);

struct WallMaterial {
  double tether_stiffness = 1.0e7;  ///< per area of each layer, dyn/cm^3
  int layers = 3;                   ///< half a grid spacing apart, outwards from the inner surface
  double node_spacing_ratio = 0.6;  ///< largest node distance in a layer, in grid spacings
};

}  // namespace valsalva::ib3d
