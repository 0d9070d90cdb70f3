// Velocity ghosts outside the domain, by reflection about the sides that are not periodic:
//   normal component      u(L - m) = +u(L + m)         (faces; the boundary face L itself is a value of its
//   own) tangential component  u(L - m) = -u(L + m - 1)     (no slip)
// On a wall, u_n = 0 and no slip give du_n/dn = 0; at an opening or open side du_n/dn = 0 together with no
// slip makes the normal traction equal the pressure. So one linear rule serves every kind of side, and its
// exact transpose `fold_mirrored` makes spreading the adjoint of interpolation up to the boundary.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Fills the ghosts beyond the domain's sides. Call after Halo::fill, whose ghosts it reflects too.
void fill_mirrored(const Level& level, MacField& u);

/// Adds what stands in the ghosts beyond the domain to the values they reflect: the transpose of
/// `fill_mirrored`. Call before Halo::accumulate.
void fold_mirrored(const Level& level, MacField& f);

}  // namespace valsalva::ib3d
