// The explicit part of the momentum equation on the MAC grid:
//     explicit viscosity  u* = u^n + dt [ w0 G^n + w1 G^{n-1} + f/rho ],   G = -div(u u) + nu lap u
//     Crank-Nicolson      u* = u^n + dt [ w0 G^n + w1 G^{n-1} + f/rho + (nu/2) lap u^n ],   G = -div(u u)
// with the variable-step Adams-Bashforth weights w1 = -dt/(2 dt_old), w0 = 1 - w1 (w1 = 0 in the first step) and
// nu = mu/rho (docs/scheme.md, equations 2.1-2.3 and 2.7).
#pragma once

#include "ib3d/fluid/openings.hpp"
#include "ib3d/fluid/upwind.hpp"
#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

enum class ViscosityScheme { explicit_, crank_nicolson };

struct FluidParameters {
  double density = 1.0;     ///< rho, g/cm^3
  double viscosity = 0.04;  ///< mu, g/(cm s)
  Advection advection = Advection::xsppm7;
  ViscosityScheme viscosity_scheme = ViscosityScheme::explicit_;
};

/// Writes u* (on all faces of the local patches, boundary faces included) and replaces `rate`, G^{n-1}, by
/// G^n. u: cm/s with ghosts filled; f: force density, dyn/cm^3, on the same faces, or null; w1 as above.
void advance_momentum(const Level& level, const FluidParameters& fluid, const MacField& u, const MacField* f,
                      double dt, double w1, MacField& rate, MacField& u_star);

/// The largest step for which the explicit viscous term is used, 6 mu dt/(rho h^2) < 0.5 (s); infinite for the implicit
/// one.
double viscous_step_limit(const Level& level, const FluidParameters& fluid);

/// Largest of |u|/h + |v|/h + |w|/h over the cells (1/s): the CFL number per unit of time. Local to the rank.
double courant_rate(const Level& level, const MacField& u);

}  // namespace valsalva::ib3d
