#include "ib3d/structure/aortic_root/root_parameters.hpp"

namespace valsalva::ib3d {

LeafletMaterial scaled(const LeafletMaterial& common, const LeafletFactors& factors)
{
  LeafletMaterial one = common;
  one.circumferential_stiffness *= factors.stiffness;
  one.radial_stiffness *= factors.stiffness;
  one.circumferential_bending *= factors.bending;
  one.radial_bending *= factors.bending;
  one.radial_rest_ratio *= factors.height;
  one.free_edge_rest_ratio *= factors.free_edge;
  return one;
}

}  // namespace valsalva::ib3d
