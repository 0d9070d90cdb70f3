// The explicit part of the momentum equation on the MAC grid:
//     explicit viscosity  u* = u^n + dt [ w0 G_b + w1 G_a + f/rho ],   G = -div(u u) + nu lap u
//     Crank-Nicolson      u* = u^n + dt [ w0 G_b + w1 G_a + f/rho + (nu/2) lap u^n ],   G = -div(u u)
// G_b, G_a: the rates found last, at t_b <= t^n, and before that, at t_a; extrapolated to the middle of the step by
//     w1 = -(t^n - t_b + dt/2)/(t_b - t_a),   w0 = 1 - w1      (w1 = 0 as long as there is no G_a)
// which is Adams-Bashforth 2 with variable steps where G is found in every step. nu = mu/rho (docs/scheme.md, equations
// 2.1-2.3 and 2.7).
#pragma once

#include "ib3d/fluid/pressure/openings.hpp"
#include "ib3d/fluid/upwind.hpp"
#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

enum class ViscosityScheme { explicit_, crank_nicolson };

struct FluidParameters {
  double density = 1.0;     ///< rho, g/cm^3
  double viscosity = 0.04;  ///< mu, g/(cm s)
  Advection advection = Advection::xsppm7;
  /// Largest sum of CFL numbers over the steps that share one evaluation of convection; 0: none do.
  double convection_cfl = 0.4;
  ViscosityScheme viscosity_scheme = ViscosityScheme::explicit_;
};

/// The convective and viscous rates of change of a velocity field, found last and before that, and their times.
struct Rates {
  CompositeMac last, before;  ///< G_b, G_a, cm/s^2
  double age = 0;             ///< t^n - t_b, s
  double gap = 0;             ///< t_b - t_a, s; 0: no G_a yet
  bool of_now = false;        ///< t_b is t^n: found in the step that is being tried

  /// Whether there is a G_b.
  bool known() const { return of_now || age > 0; }
  /// Makes room for rates at t^n in `last`, once in a step.
  void renew();
  /// After a step dt.
  void accept(double dt);
  /// w1 of a step dt.
  double weight_before(double dt) const { return gap > 0 ? -(age + 0.5 * dt) / gap : 0.0; }
};

/// Writes u* (on all faces of the local patches, boundary faces included) and G of u into `rate`. u: cm/s with ghosts
/// filled; f: force density, dyn/cm^3, on the same faces, or null; w1 as above.
void advance_momentum(const Level& level, const FluidParameters& fluid, const MacField& u, const MacField* f,
                      double dt, double w1, MacField& rate, const MacField& rate_before, MacField& u_star);
/// The same with the rates as they are: no convection is evaluated.
void advance_momentum_kept(const Level& level, const FluidParameters& fluid, const MacField& u,
                           const MacField* f, double dt, double w1, const MacField& rate,
                           const MacField& rate_before, MacField& u_star);

/// The largest step for which the explicit viscous term is used, 6 mu dt/(rho h^2) < 0.5 (s); infinite for the implicit
/// one.
double viscous_step_limit(const Level& level, const FluidParameters& fluid);

}  // namespace valsalva::ib3d
