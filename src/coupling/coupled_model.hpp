// The 3D root and the 0D circulation as one model, stepped together; u, X and the network's states are all at
// t^n between steps. Schemes (key coupling.scheme):
//   implicit  the network's answer to the flow at the end of the step closes the step: second order, no stability limit
//   explicit  pressures from the flow at t^n: first order, for comparison; stable while dt < dt*
#pragma once

#include <optional>

#include "coupling/circulation.hpp"
#include "coupling/interface_state.hpp"
#include "ib3d/immersed_boundary.hpp"

namespace valsalva::coupling {

enum class CouplingScheme { implicit_, explicit_ };

/// Keys of [time].
struct StepControl {
  double cfl = 0.4;              ///< largest CFL number
  double elastic_safety = 0.95;  ///< share of the elastic bound 2/omega_max that is used
  double dt_max_s = 2e-4;
  double dt_fixed_s = 0;  ///< > 0: this step, shortened only to land on output times and kinks
};

/// What a step was, for step.csv: divergence in 1/s, rms and largest.
struct StepReport {
  long step = 0;
  double t_s = 0, dt_s = 0;
  ib3d::Limit limited_by = ib3d::Limit::longest;
  double cfl = 0;
  int iterations = 0;
  double divergence_rms = 0, divergence_max = 0;
};

class CoupledModel {
 public:
  /// `solver` and `circulation` must outlive the model; the ports of the circulation are the openings of the
  /// root.
  CoupledModel(ib3d::ImmersedBoundarySolver& solver, Circulation& circulation, CouplingScheme scheme,
               const StepControl& control, Timers& timers);

  /// The step that the bounds allow, shortened to land on `t_stop` and on the kinks of the sources. Throws SolverError
  /// when a fixed step is beyond the structure's bound: it would not blow up but shake the leaflets to tatters.
  ib3d::StepBound next_step(double t_stop);
  /// One step t^n -> t^{n+1}. Collective. Throws SolverError when numbers go bad.
  StepReport advance(const ib3d::StepBound& step);

  /// Time reached, s.
  double t() const { return circulation_.state().t; }
  long step() const { return step_; }
  /// Pressures and flows at t.
  const InterfaceState& interface() const { return interface_; }
  const ib3d::ImmersedBoundarySolver& solver() const { return solver_; }
  const Circulation& circulation() const { return circulation_; }
  /// What has come into the 3D root through its openings since the start, less what went out, mmHg ml: work of the
  /// opening pressures, and kinetic energy that the flow carries.
  double pressure_work() const { return pressure_work_; }
  double kinetic_inflow() const { return kinetic_inflow_; }
  /// Inertance seen from opening m, mmHg s^2/ml: what flow acceleration costs in pressure.
  double inertance(int m) const;

  /// Everything at t^n, of both sides: a restored model continues bit for bit on the same ranks, to rounding
  /// on others. Collective.
  void save_or_restore(Checkpoint& c);

 private:
  Eigen::MatrixXd conductance() const;  ///< W in ml/s^2 per mmHg
  void predict_pressures(double dt);
  void account_energy(double dt, const Eigen::VectorXd& p);
  void check_numbers(double dt, const Eigen::VectorXd& Q) const;

  ib3d::ImmersedBoundarySolver& solver_;
  Circulation& circulation_;
  CouplingScheme scheme_;
  StepControl control_;
  Timers& timers_;
  InterfaceState interface_;
  std::vector<double> flow_before_, kinetic_outflow_;
  double pressure_work_ = 0, kinetic_inflow_ = 0;
  Eigen::VectorXd p_used_;
  double dt_before_ = 0;
  long step_ = 0;
};

}  // namespace valsalva::coupling
