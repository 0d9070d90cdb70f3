// The largest stable step: dt = min(CFL, elastic, viscous bound); coupled_model.cpp adds growth and output times.
//   CFL      dt <= C h / max(|u| + |v| + |w|)
//   elastic  the structure is explicit, so dt < 2/omega_max, omega_max^2 the largest eigenvalue of (1/rho) J S K at the
//            present configuration (K = -dF/dX the structure's stiffness); found by power iteration, warm-started, and
//            an upper bound since the projection, which can only lower it, is left out
// Slack tension-only springs count as taut: valve leaflets go slack as they open and snap taut within a few steps.
#pragma once

#include <vector>

#include "ib3d/interaction/node_distribution.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"

namespace valsalva::ib3d {

/// What limits a step; `longest` is time.dt_max_s, `target` an output time, a source's kink or the end.
enum class Limit { longest, cfl, elastic, viscous, growth, target, fixed };

struct StepBound {
  double dt = 0;  ///< s
  Limit limited_by = Limit::longest;
};

/// As in the column dt_bound of step.csv.
constexpr const char* limit_name(Limit l)
{
  constexpr const char* names[] = {"longest", "cfl", "elastic", "viscous", "growth", "output", "fixed"};
  return names[static_cast<int>(l)];
}

/// Power iteration for omega_max of the structure immersed in the fluid.
class ElasticBound {
 public:
  /// Of the finest level; density in g/cm^3.
  ElasticBound(const Level& level, double density) : comm_(level.comm), density_(density), f_(level) {}

  /// `sweeps` more power iterations at the positions X (all local nodes); returns omega_max (1/s), 0 without
  /// a structure. Collective.
  double update(const NodeDistribution& nodes, const Interaction& interaction, const std::vector<Vec3>& X,
                int sweeps);
  double omega() const { return omega_; }
  /// Forgets the eigenvector: call after nodes have changed ranks (the estimate of omega is kept until the
  /// next update).
  void restart() { started_ = false; }
  /// omega and its eigenvector. Collective.
  void save_or_restore(Checkpoint& c, const NodeDistribution& nodes);

 private:
  MPI_Comm comm_;
  double density_;
  MacField f_;
  std::vector<Vec3> v_, stiff_;
  bool started_ = false;  ///< the same on all ranks
  double omega_ = 0;
};

}  // namespace valsalva::ib3d
