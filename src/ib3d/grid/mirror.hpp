// Velocity ghosts outside the domain, by reflection about the sides that are not periodic:
//   normal component      u(L - m) = +u(L + m)        (faces; the boundary face L itself is a value of its own)
//   tangential component  u(L - m) = -u(L + m - 1)    (no slip)
// On a wall, u_n = 0 and no slip give du_n/dn = 0; at an opening or open side du_n/dn = 0 together with no slip makes
// the normal traction equal the pressure. So one linear rule serves every kind of side.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Fills this many layers of ghosts beyond the domain's sides. Call after Halo::fill, whose ghosts it reflects too.
void fill_mirrored(const Level& level, MacField& u, int layers);

}  // namespace valsalva::ib3d
