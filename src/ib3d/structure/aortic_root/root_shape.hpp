// The inner surface of the aortic root as formulas. With theta about the axis (a leaflet is centred on 0, 120
// and 240 degrees), phi = theta folded to +-60 degrees, s = R phi, S(x) = 3x^2 - 2x^3 clipped to [0, 1]:
//   attachment  z_att(s) = H (1 - sqrt(1 - (s/Ra)^2)) above the annulus, Ra = pi R/3 (half a leaflet's width)
//   tube        r_t(z)   = R + (R_asc - R) S((z - z_ann - H)/1.4) + flare [S(1 - z) + S(1 - (length - z))]
//   wall        r        = r_t + B cos^2(1.5 phi) sin(pi zeta),
//               zeta = clip((z - z_ann - z_att)/(z_stj - z_ann - z_att), 0, 1)
// so each sinus begins on the attachment line, and the leaflet's edge lies on the tube. Lengths in cm, angles
// in radians. The flare keeps the rim of the tube away from the rim of the pressure disc.
#pragma once

#include "ib3d/structure/aortic_root/root_parameters.hpp"

namespace valsalva::ib3d {

/// Length over which the tube passes from the annulus radius to the ascending radius, cm.
inline constexpr double kAscendingTransition = 1.4;

/// S(x): 0 below 0, 1 above 1, smooth between.
double smooth_step(double x);

/// Half of a leaflet's width on the tube, Ra = pi R/3, cm.
double leaflet_half_width(const RootDimensions& root);

/// Height of the attachment line above the annulus at arc length s from the leaflet's middle, |s| <= Ra.
double attachment_height(const RootDimensions& root, double s);

/// Its inverse: the arc length |s| at which the attachment line is at `height` above the annulus, 0..H.
double attachment_half_width(const RootDimensions& root, double height);

/// Inner radius of the wall at angle theta and height z, on a grid of spacing h.
double wall_radius(const RootDimensions& root, double h, double theta, double z);

}  // namespace valsalva::ib3d
