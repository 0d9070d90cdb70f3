#include "ib3d/structure/aortic_root/root_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace valsalva::ib3d {

using std::numbers::pi;

double smooth_step(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double leaflet_half_width(const RootDimensions& root)
{
  return pi * root.annulus_radius / 3.0;
}

double attachment_height(const RootDimensions& root, double s)
{
  const double x = s / leaflet_half_width(root);
  return root.commissure_height * (1.0 - std::sqrt(std::max(0.0, 1.0 - x * x)));
}

double attachment_half_width(const RootDimensions& root, double height)
{
  const double y = 1.0 - height / root.commissure_height;
  return leaflet_half_width(root) * std::sqrt(std::max(0.0, 1.0 - y * y));
}

double wall_radius(const RootDimensions& root, double h, double theta, double z)
{
  const double third = 2.0 * pi / 3.0;
  const double phi = theta - third * std::round(theta / third);
  const double flare = root.end_flare_spacings * h;
  const double tube = root.annulus_radius +
                      (root.ascending_radius - root.annulus_radius) *
                          smooth_step((z - root.annulus_z - root.commissure_height) / kAscendingTransition) +
                      flare * (smooth_step(1.0 - z) + smooth_step(1.0 - (root.length - z)));
  const double sinus_begin = root.annulus_z + attachment_height(root, root.annulus_radius * phi);
  const double zeta = std::clamp((z - sinus_begin) / (root.sinus_end_z - sinus_begin), 0.0, 1.0);
  const double lobe = std::cos(1.5 * phi);
  return tube + root.sinus_bulge * lobe * lobe * std::sin(pi * zeta);
}

}  // namespace valsalva::ib3d
