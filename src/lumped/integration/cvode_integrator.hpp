// Integrates a lumped network in time with CVODES: Adams methods of variable order and step, functional
// iteration, relative tolerance 1e-8; absolute tolerances are the relative one times 1 mmHg, 1 ml, 10 ml/s.
// In pieces shorter than 0.05 s (of an advance, or between kinks) all tolerances shrink in proportion, so that
// many short advances are as accurate as one long. It stops exactly at the kinks of the sources, and where a valve switches it restarts
// with the valve's new position. CVODE is re-initialised in every call, so the same state and flows give
// bitwise the same result, whatever was computed before: iterations of a coupling scheme and restarts repeat
// exactly. With Tangents it carries S = dy/dp along, under the same error control. mmHg, ml, s.
// Source: Hindmarsh et al., ACM Trans Math Softw 31 (2005) 363-396.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lumped/integration/tangents.hpp"
#include "lumped/network/lumped_state.hpp"
#include "lumped/network/network.hpp"

namespace valsalva::lumped {

class CvodeMemory;

/// Counts since the integrator was made.
struct IntegratorStatistics {
  long steps = 0;
  long rhs_evaluations = 0;
  long events = 0;  ///< valves that switched
};

/// A valve takes another position.
struct Switching {
  double t;  ///< s
  int valve;
  bool open;
};

using SensitivityObserver = std::function<void(const LumpedState& state, const Eigen::MatrixXd& S)>;

class CvodeIntegrator {
 public:
  /// `network` must outlive the integrator.
  explicit CvodeIntegrator(const LumpedNetwork& network, double rtol = 1e-8)
      : CvodeIntegrator(network, nullptr, rtol)
  {
  }
  /// With sensitivities along the directions of `tangents`, which must outlive the integrator as well.
  CvodeIntegrator(const LumpedNetwork& network, Tangents& tangents, double rtol = 1e-8)
      : CvodeIntegrator(network, &tangents, rtol)
  {
  }
  ~CvodeIntegrator();
  CvodeIntegrator(const CvodeIntegrator&) = delete;
  CvodeIntegrator& operator=(const CvodeIntegrator&) = delete;

  /// Takes `state` from its time to `t_end` >= state.t (s). The port flows (ml/s, one per port, positive into
  /// the network) vary linearly from `Q_begin` to `Q_end`. SolverError if CVODE fails; `state` is then
  /// unchanged.
  void advance(LumpedState& state, double t_end, std::span<const double> Q_begin,
               std::span<const double> Q_end);

  /// The same with S = dy/dp, without flow through the ports. Only of an integrator with Tangents.
  void advance(LumpedState& state, Eigen::MatrixXd& S, double t_end);
  /// The same, with `observe` called at each of `times` (increasing, from state.t to t_end). Between events
  /// CVODES' own interpolation serves: samples cost no restart.
  void advance(LumpedState& state, Eigen::MatrixXd& S, double t_end, std::span<const double> times,
               const SensitivityObserver& observe);

  /// mmHg, one per port.
  std::vector<double> port_pressures(const LumpedState& state, std::span<const double> Q) const
  {
    return network_.port_pressures(state, Q);
  }

  const IntegratorStatistics& statistics() const { return statistics_; }
  /// During the last advance, in order.
  const std::vector<Switching>& switchings() const { return switchings_; }

 private:
  struct Callbacks;
  CvodeIntegrator(const LumpedNetwork& network, Tangents* tangents, double rtol);

  void advance_with(Eigen::MatrixXd* S, LumpedState& state, double t_end);
  void set_port_flows(double t);
  void advance_smooth_piece(LumpedState& state, double stop);
  void settle(LumpedState& state);
  void note_switch(int valve, const LumpedState& state);
  /// From a fresh start to `stop` or the next switching of a valve. True if valves switched.
  bool run_cvode(LumpedState& state, double stop);
  void observe_due(const LumpedState& state);
  double first_step(const LumpedState& state, double stop);
  /// Over an interval too short for CVODE.
  void step_over(LumpedState& state, double stop);
  void rates(double t, const double* y, double* dydt);
  [[noreturn]] void fail(int flag, double t, double stop) const;

  const LumpedNetwork& network_;
  Tangents* tangents_;  ///< may be null
  double rtol_;
  NodalCircuit<double> circuit_;
  std::unique_ptr<CvodeMemory> memory_;
  IntegratorStatistics statistics_;
  std::vector<Switching> switchings_;
  std::vector<double> scale_;  ///< per state: absolute over relative tolerance
  std::string message_;        ///< what CVODE last complained of

  // The call of advance() in progress.
  double t_begin_ = 0.0, t_end_ = 0.0;
  std::span<const double> Q_begin_, Q_end_;
  std::vector<double> Q_;
  Eigen::MatrixXd* S_ = nullptr;
  std::span<const double> times_;  ///< still to be observed
  const SensitivityObserver* observe_ = nullptr;
  double piece_ = 0.0;
  double step_rtol_ = 0.0;
  std::vector<int> valve_open_;
  std::vector<double> scratch_y_, scratch_rates_, start_rates_;
  std::vector<int> switched_;
  std::vector<const double*> S_columns_;
  std::vector<double*> dSdt_columns_;
};

}  // namespace valsalva::lumped
