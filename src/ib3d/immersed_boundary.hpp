// The three-dimensional side: fluid, structure and their interaction in one domain with openings.
// One step t^n -> t^{n+1} in three calls, so that the 0D networks can answer in between (docs/scheme.md,
// section 2):
//   begin_step(dt)      elastic force, spread to the grid, explicit part of the momentum equation
//   solve_fluid(p)      pressure for these opening pressures -> flows
//   accept(phi)         opening pressures corrected by phi, velocity projected, structure moved
// Until `accept` all is as it was at t^n: a step can be given up and begun again with another dt.
// Structure updates (key structure.scheme):
//   leapfrog  F[X^n] drives u^{n+1};  X^{n+1} = X^n + dt J[X^n] u^{n+1}
//   midpoint  X' = X^n + dt/2 J[X^n] u^n;  F[X'] drives u^{n+1};  X^{n+1} = X^n + dt J[X'] (u^n + u^{n+1})/2
// J u is joined by the slip of the structure, if it has any. It is known as an ElasticModel alone.
// All calls are collective. dyn, cm, s.
#pragma once

#include <memory>

#include "common/timers.hpp"
#include "ib3d/fluid/navier_stokes.hpp"
#include "ib3d/grid/refinement.hpp"
#include "ib3d/interaction/markers.hpp"
#include "ib3d/time_step.hpp"

namespace valsalva::ib3d {

enum class StructureScheme { leapfrog, midpoint };

class ImmersedBoundarySolver {
 public:
  /// `refinement` says when and how the grid follows the structure and the flow, `seeds` where passive markers start.
  /// Throws SolverError when a node lies outside the domain.
  ImmersedBoundarySolver(Hierarchy grid, std::vector<Opening> openings, const FluidParameters& fluid,
                         const PressureOptions& pressure, std::unique_ptr<const ElasticModel> structure,
                         StructureScheme scheme, Timers& timers, RefinementPolicy refinement = {},
                         std::vector<MarkerSeed> seeds = {});

  void begin_step(double dt);
  std::vector<double> solve_fluid(const std::vector<double>& opening_pressure);
  void accept(const std::vector<double>& phi);
  /// Releases the markers that are due at time t: at the start, and after every step.
  void seed_markers(double t) { markers_.seed_due(*grid_, fluid_->u(), t); }

  /// Largest of |u| + |v| + |w| over h in the current velocity (1/s), the same on all ranks.
  double courant_rate() const { return courant_rate_; }
  /// omega_max of the structure (1/s), refreshed every few steps.
  double elastic_rate();

  /// Energy of the structure, erg. Collective.
  double elastic_energy() const { return nodes_.whole().energy(nodes_.gather(X_)); }

  const Hierarchy& grid() const { return *grid_; }
  const NavierStokes& fluid() const { return *fluid_; }
  const NodeDistribution& nodes() const { return nodes_; }
  /// Positions of the local nodes, owned ones first, copies after them (current up to the last `accept`).
  const std::vector<Vec3>& X() const { return X_; }
  const Markers& markers() const { return markers_; }

  /// Everything at t^n, between steps. Collective.
  void save_or_restore(Checkpoint& c);

 private:
  /// After nodes of this rank have moved by at most `moved_cells` along any direction.
  void check_and_redistribute(double moved_cells);
  void regrid_if_moved();
  /// Moves everything to refined levels of these boxes, made for nodes at X (all of them).
  void rebuild(const Refinement& boxes, const std::vector<Vec3>& X);

  StructureScheme scheme_;
  Timers& timers_;
  RefinementPolicy policy_;
  std::unique_ptr<const Hierarchy> grid_;  ///< outlives all that refers to it
  std::unique_ptr<NavierStokes> fluid_;
  NodeDistribution nodes_;
  Interaction interaction_;
  ElasticBound elastic_;
  Markers markers_;
  MacField f_;
  std::vector<Vec3> X_, X_middle_, U_, U_before_, F_;
  double dt_ = 0, cfl_ = 0;  ///< of the step under way; the CFL number with viscosity's share
  double courant_rate_ = 0;
  std::vector<Vec3> X_of_cuts_;  ///< all nodes where the ranks' regions were chosen
  std::vector<Vec3> X_of_grid_;  ///< all nodes where the grid was last found to fit them
  double moved_cells_ = 0;       ///< bound of how far anything tagged has moved since
  double room_cells_ = 0;        ///< how far nodes may surely move before one is too far out of its patch
  int steps_since_elastic_ = 0;
  int steps_since_convection_ = 0;
  double cfl_since_convection_ = 0;
};

}  // namespace valsalva::ib3d
