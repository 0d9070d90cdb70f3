// The 0D side as the coupling sees it: a network with its integrator and its state at t^n, asked again and
// again for the port pressures at the end of a step, and advanced once the flows are settled. Rank 0 integrates
// and hands its numbers to the others: processors that differ would give numbers that differ, and ranks that
// disagree about a step. Every call but the observers is collective; errors are thrown on all ranks.
//
// Implicit closure (docs/scheme.md, section 4). The 3D side answers linearly, Q = Q0 - G phi, to a change phi
// of the opening pressures from those it has used; the network answers with p(Q), the mean of its port
// pressures at both ends of the step. So phi solves
//     p_used + phi = p(Q0 - G phi)
// by Newton's method with dp/dQ from differences, kept while it converges. No second 3D solve. Pressures
// mmHg.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "common/checkpoint.hpp"
#include "common/comm.hpp"
#include "lumped/integration/cvode_integrator.hpp"

namespace valsalva::coupling {

/// Flows Q in ml/s, one per port, positive into the network.
class Circulation {
 public:
  /// The network of `spec` from its initial state; its ports in the order of the openings. Throws CaseError.
  Circulation(const lumped::NetworkSpec& spec, const Communicator& comm);
  /// The same from the given state, that of rank 0.
  Circulation(const lumped::NetworkSpec& spec, lumped::LumpedState start, const Communicator& comm);

  const lumped::LumpedNetwork& network() const { return network_; }
  const lumped::LumpedState& state() const { return state_; }
  int port_count() const { return network_.port_count(); }

  /// Port pressures at t^n for these flows.
  std::vector<double> pressures(const std::vector<double>& Q) const;
  /// Mean port pressure over the next step if the flows go from Q (at t^n) to Q_end.
  Eigen::VectorXd mean_pressures(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q_end);

  /// phi of the closure above. `G` in ml/s per mmHg, positive diagonal. Throws SolverError without
  /// convergence.
  Eigen::VectorXd close(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                        const Eigen::MatrixXd& G, const Eigen::VectorXd& p_used);
  /// Takes the network to t^n + dt with flows going from Q to Q_end.
  void advance(double dt, const std::vector<double>& Q, const std::vector<double>& Q_end);

  /// Network evaluations (integrations over one step) that this rank has made: none but on rank 0.
  long evaluations() const { return evaluations_; }

  /// Restores the state and what speeds up the next closure, so that steps repeat bit for bit. Collective.
  void save_or_restore(Checkpoint& c);

 private:
  Eigen::VectorXd integrate(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q_end);
  Eigen::VectorXd solve_closure(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                                const Eigen::MatrixXd& G, const Eigen::VectorXd& p_used);
  Eigen::VectorXd from_rank_0(const std::function<Eigen::VectorXd()>& work) const;
  void share_state(const std::function<void()>& work);
  void update_resistance(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q_end,
                         const Eigen::VectorXd& p_end);

  Communicator comm_;
  lumped::LumpedNetwork network_;
  lumped::CvodeIntegrator integrator_;
  lumped::LumpedState state_;
  // Of rank 0.
  Eigen::MatrixXd resistance_;  ///< d(mean p)/dQ_end, mmHg s/ml
  double resistance_dt_ = 0;
  long evaluations_ = 0;
};

}  // namespace valsalva::coupling
