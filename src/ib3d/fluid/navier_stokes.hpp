// One projection step of the incompressible Navier-Stokes equations on the MAC grid, for given force density
// and opening pressures (docs/scheme.md, section 2):
//     u*      = u^n + dt [ G + f/rho ]                            begin_step: G extrapolated (momentum.hpp); the implicit
//                                                                 half of Crank-Nicolson viscosity: solve_pressure
//     lap p   = (rho/dt) div u*,  p = p_k on opening k            solve_pressure -> flows Q0
//     u^{n+1} = u* - (dt/rho) grad p                              finish_step(phi)
// on all levels with one dt; coarse faces under finer ones hold the mean of these. The whole pressure is solved for in
// each step, so there is no splitting error; the superposition of opening modes lets the coupling correct the opening
// pressures by phi between the last two calls. Until finish_step the state stays that of t^n: a step can be given up and
// begun again with another dt or force. Fields have one entry per level. All calls are collective.
#pragma once

#include <optional>

#include "common/checkpoint.hpp"
#include "ib3d/fluid/momentum.hpp"
#include "ib3d/fluid/opening_modes.hpp"
#include "ib3d/fluid/viscous.hpp"

namespace valsalva::ib3d {

class NavierStokes {
 public:
  /// `grid` must outlive the object.
  NavierStokes(const Hierarchy& grid, std::vector<Opening> openings, const FluidParameters& fluid,
               const PressureOptions& pressure);

  /// The same flow on another hierarchy (a regrid), between steps: fields and history are carried over.
  NavierStokes(const Hierarchy& grid, const NavierStokes& before);

  NavierStokes(const NavierStokes&) = delete;  // its members refer to each other
  NavierStokes& operator=(const NavierStokes&) = delete;

  /// u* from u^n; f in dyn/cm^3 on the faces of the finest level, complete on the owned ones; none on the others.
  /// keep_rates: convection and explicit viscosity are extrapolated from where they were found before instead of being
  /// found at t^n (not in the first step after set_velocity). Rates once found at t^n stay when the step is begun again:
  /// `keep_rates` then keeps those.
  void begin_step(const MacField& f, double dt, bool keep_rates = false);
  /// The same with a force on all levels.
  void begin_step(const CompositeMac& f, double dt, bool keep_rates = false);
  /// Solves for p with these mean opening pressures (dyn/cm^2, one per opening) and returns the flows (ml/s,
  /// outward) that would result. Where the profile is not uniform the pressure on a face is lowered by
  /// rho (w|w| - W|W|), w the inward velocity and W its mean over the disc: neutral for plug flow, it keeps
  /// recirculation at an opening from growing.
  std::vector<double> solve_pressure(const std::vector<double>& opening_pressure);
  /// Whether the rates of the step under way were found at t^n.
  bool rates_found() const { return rates_.of_now; }
  /// Adds phi (dyn/cm^2) to the opening pressures by superposition, corrects the velocity and makes velocity, pressure and
  /// rates of change those of t^{n+1}.
  void finish_step(const std::vector<double>& phi);

  const CompositeMac& u() const { return u_; }             ///< u^n, ghosts filled
  const CompositeMac& u_before() const { return u_new_; }  ///< u^{n-1} after finish_step, ghosts filled
  const CompositeCells<double>& p() const { return p_; }
  const KrylovReport& pressure_report() const { return report_; }
  /// Sweeps of the last viscous solve, 0 with explicit viscosity.
  int viscous_sweeps() const { return viscous_sweeps_; }
  /// rms and largest divergence (1/s) that the last pressure solve left behind.
  double divergence_rms() const { return report_.final_rms * dt_ / fluid_.density; }
  double divergence_max() const { return report_.final_max * dt_ / fluid_.density; }

  const Hierarchy& grid() const { return grid_; }
  const std::vector<Opening>& openings() const { return openings_; }
  const FluidParameters& fluid() const { return fluid_; }
  const OpeningModes& modes() const { return modes_; }

  /// What kinetic energy flows out through every opening now, erg/s: the sum of (rho/2) w^3 over its faces. Collective.
  std::vector<double> kinetic_outflow() const;
  /// Largest of |u|/h + |v|/h + |w|/h over the cells (1/s): the CFL number per unit of time. Local to the rank.
  double courant_rate() const;
  /// Replaces the velocity (all faces of the local patches), forgetting the history: for initial conditions and tests.
  void set_velocity(const CompositeMac& u);
  /// What the next step needs of the last one. Collective.
  void save_or_restore(Checkpoint& c);

 private:
  void compute_u_star(const std::vector<const MacField*>& f, double dt, bool keep_rates);
  void prescribe(const std::vector<double>& opening_pressure);
  void diffuse();
  /// u_new_ -= (dt/rho) grad p.
  void subtract_gradient(double dt);
  void average_down(CompositeMac& u);
  void fill_velocity_ghosts(CompositeMac& u);
  void fill_velocity_ghosts(std::size_t l, CompositeMac& u);
  /// Closes the walls, averages down and fills the ghosts.
  void complete(CompositeMac& u);

  const Hierarchy& grid_;
  std::vector<Opening> openings_;
  FluidParameters fluid_;
  std::vector<CoarseFine> transfers_;
  OpeningFaces opening_faces_;
  PressureSolver solver_;
  OpeningModes modes_;
  std::optional<ViscousSolver> viscous_;  ///< with Crank-Nicolson viscosity
  std::vector<Halo> faces_;               ///< all ghosts of a velocity, per level
  std::vector<Halo> shared_faces_;        ///< only the faces that two patches share, from their owner
  CompositeMac u_, u_new_;
  Rates rates_;
  CompositeCells<double> p_, p_before_, p_new_;
  std::vector<BoundaryPressure> p_b_;
  KrylovReport report_;
  int viscous_sweeps_ = 0;
  double dt_ = 0, dt_before_ = 0;      ///< of the step that was begun last and of the last one finished
  std::optional<double> finest_rate_;  ///< Courant rate of u_ on the finest level, where a step has left it
};

}  // namespace valsalva::ib3d
