#include "lumped/integration/cvode_integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/error.hpp"
#include "lumped/integration/cvode_memory.hpp"

namespace valsalva::lumped {

namespace {

// CVODE bounds the error of each step; with a restart in every advance and at every kink those errors add up
// with the number of pieces. Below this length the tolerances shrink with the piece, so that the sum does not
// depend on the splitting.
constexpr double kFullToleranceInterval_s = 0.05;
constexpr double kSmallestRtol = 1e-13;

constexpr int kMostSwitches = 1000;  // within one smooth piece; a heart beat has four

double absolute_scale(const std::string& unit)
{
  return unit == "mmHg ml" ? 1000.0 : unit == "ml/s" ? 10.0 : 1.0;
}

}  // namespace

/// What CVODE calls; `user_data` is the integrator.
struct CvodeIntegrator::Callbacks {
  static int rates(double t, N_Vector y, N_Vector dydt, void* user_data)
  {
    auto& self = *static_cast<CvodeIntegrator*>(user_data);
    double* result = N_VGetArrayPointer(dydt);
    try {
      self.rates(t, N_VGetArrayPointer(y), result);
    } catch (const SolverError&) {
      return 1;
    }
    const bool finite =
        std::all_of(result, result + self.network_.state_count(), [](double r) { return std::isfinite(r); });
    return finite ? 0 : 1;
  }

  static int switch_margins(double t, N_Vector y, double* margins, void* user_data)
  {
    auto& self = *static_cast<CvodeIntegrator*>(user_data);
    self.set_port_flows(t);
    try {
      self.network_.switch_margins({t, self.piece_}, N_VGetArrayPointer(y), self.valve_open_, self.Q_,
                                   self.circuit_, margins);
    } catch (const SolverError&) {
      return 1;
    }
    return 0;
  }

  static int tangents(int, double t, N_Vector y, N_Vector, N_Vector* S, N_Vector* dSdt, void* user_data,
                      N_Vector, N_Vector)
  {
    auto& self = *static_cast<CvodeIntegrator*>(user_data);
    const std::size_t count = static_cast<std::size_t>(self.tangents_->count());
    for (std::size_t k = 0; k < count; ++k) {
      self.S_columns_[k] = N_VGetArrayPointer(S[k]);
      self.dSdt_columns_[k] = N_VGetArrayPointer(dSdt[k]);
    }
    try {
      self.tangents_->rates({t, self.piece_}, N_VGetArrayPointer(y), self.valve_open_, self.S_columns_.data(),
                            self.dSdt_columns_.data());
    } catch (const SolverError&) {
      return 1;
    }
    return 0;
  }

  static void keep_message(int, const char*, const char*, char* message, void* user_data)
  {
    static_cast<CvodeIntegrator*>(user_data)->message_ = message;
  }
};

CvodeIntegrator::CvodeIntegrator(const LumpedNetwork& network, Tangents* tangents, double rtol)
    : network_(network),
      tangents_(tangents),
      rtol_(rtol),
      circuit_(network.make_circuit()),
      Q_(static_cast<std::size_t>(network.port_count())),
      valve_open_(static_cast<std::size_t>(network.valve_count())),
      scratch_y_(static_cast<std::size_t>(network.state_count())),
      scratch_rates_(scratch_y_),
      start_rates_(scratch_y_),
      switched_(valve_open_)
{
  for (const auto& state : network.states()) scale_.push_back(absolute_scale(state.unit));
  std::vector<double> direction_scale;
  if (tangents) direction_scale = tangents->scales();
  S_columns_.resize(direction_scale.size());
  dSdt_columns_.resize(direction_scale.size());
  if (network.state_count() > 0)
    memory_ =
        std::make_unique<CvodeMemory>(scale_, direction_scale, network.valve_count(),
                                      CvodeFunctions{Callbacks::rates, Callbacks::switch_margins,
                                                     Callbacks::tangents, Callbacks::keep_message, this});
}

CvodeIntegrator::~CvodeIntegrator() = default;

void CvodeIntegrator::advance(LumpedState& state, double t_end, std::span<const double> Q_begin,
                              std::span<const double> Q_end)
{
  if (Q_begin.size() != Q_.size() || Q_end.size() != Q_.size())
    throw SolverError(fmt::format("the lumped network has {} ports, but {} and {} port flows were given",
                                  Q_.size(), Q_begin.size(), Q_end.size()));
  t_begin_ = state.t;
  t_end_ = t_end;
  Q_begin_ = Q_begin;
  Q_end_ = Q_end;
  times_ = {};
  advance_with(nullptr, state, t_end);
}

void CvodeIntegrator::advance(LumpedState& state, Eigen::MatrixXd& S, double t_end)
{
  advance(state, S, t_end, {}, [](const LumpedState&, const Eigen::MatrixXd&) {});
}

void CvodeIntegrator::advance(LumpedState& state, Eigen::MatrixXd& S, double t_end,
                              std::span<const double> times, const SensitivityObserver& observe)
{
  const std::vector<double> no_flow(Q_.size(), 0.0);
  t_begin_ = state.t;
  t_end_ = t_end;
  Q_begin_ = Q_end_ = no_flow;
  times_ = times;
  observe_ = &observe;
  Eigen::MatrixXd next = S;
  advance_with(&next, state, t_end);
  S = std::move(next);
}

void CvodeIntegrator::advance_with(Eigen::MatrixXd* S, LumpedState& state, double t_end)
{
  if (!(t_end >= state.t))
    throw SolverError(
        fmt::format("the lumped network stands at t = {} s and cannot go back to {} s", state.t, t_end));
  S_ = S;
  switchings_.clear();
  LumpedState next = state;
  observe_due(next);
  while (next.t < t_end) {
    const double before = next.t, kink = network_.next_kink(before);
    const bool crosses = kink < t_end - kTimeResolution_s;
    advance_smooth_piece(next, crosses ? kink : t_end);
    if (S && crosses)
      tangents_->follow_kink(before, 0.5 * (kink + std::min(t_end, network_.next_kink(kink))), next, *S);
    observe_due(next);
  }
  state = std::move(next);
}

void CvodeIntegrator::set_port_flows(double t)
{
  const double s = t_end_ > t_begin_ ? (t - t_begin_) / (t_end_ - t_begin_) : 0.0;
  for (std::size_t i = 0; i < Q_.size(); ++i) Q_[i] = Q_begin_[i] + s * (Q_end_[i] - Q_begin_[i]);
}

void CvodeIntegrator::rates(double t, const double* y, double* dydt)
{
  ++statistics_.rhs_evaluations;
  set_port_flows(t);
  network_.rates({t, piece_}, y, valve_open_, Q_, circuit_, dydt);
}

void CvodeIntegrator::advance_smooth_piece(LumpedState& state, double stop)
{
  piece_ = 0.5 * (state.t + stop);
  step_rtol_ = std::max(rtol_ * std::min(1.0, (stop - state.t) / kFullToleranceInterval_s),
                        std::min(rtol_, kSmallestRtol));
  settle(state);
  for (int switches = 0; stop - state.t > kTimeResolution_s && network_.state_count() > 0; ++switches) {
    if (switches > kMostSwitches)
      throw SolverError(
          fmt::format("the valves of the lumped network switched more than {} times up to t = {} s; a "
                      "valve flutters. Give it an inertance or a larger resistance.",
                      kMostSwitches, state.t));
    if (run_cvode(state, stop)) settle(state);
  }
  if (state.t < stop) {
    step_over(state, stop);
    settle(state);
  }
}

void CvodeIntegrator::settle(LumpedState& state)
{
  set_port_flows(state.t);
  for (int valve : network_.settle_valves({state.t, piece_}, state, Q_, circuit_)) note_switch(valve, state);
}

void CvodeIntegrator::note_switch(int valve, const LumpedState& state)
{
  if (S_) tangents_->follow_switch(valve, state, *S_);
  switchings_.push_back({state.t, valve, state.valve_open[static_cast<std::size_t>(valve)] != 0});
  ++statistics_.events;
}

bool CvodeIntegrator::run_cvode(LumpedState& state, double stop)
{
  valve_open_ = state.valve_open;
  double t = state.t;
  int flag = memory_->restart(t, state.y, S_, step_rtol_, first_step(state, stop), stop);
  while (flag >= 0 && flag != CV_ROOT_RETURN && t < stop) {
    const bool samples = !times_.empty() && times_.front() < stop;
    flag = memory_->advance(samples ? times_.front() : stop, t, state.y, S_);
    if (!samples || flag < 0 || flag == CV_ROOT_RETURN) break;
    state.t = t;
    observe_due(state);
  }
  if (flag < 0) fail(flag, t, stop);
  long steps = 0;
  CVodeGetNumSteps(memory_->cvode(), &steps);
  statistics_.steps += steps;

  state.t = flag == CV_ROOT_RETURN ? t : stop;
  if (flag != CV_ROOT_RETURN) return false;
  CVodeGetRootInfo(memory_->cvode(), switched_.data());
  for (std::size_t v = 0; v < switched_.size(); ++v)
    if (switched_[v] != 0) {
      network_.switch_valve(static_cast<int>(v), state);
      note_switch(static_cast<int>(v), state);
    }
  return true;
}

void CvodeIntegrator::observe_due(const LumpedState& state)
{
  for (; !times_.empty() && times_.front() <= state.t + kTimeResolution_s; times_ = times_.subspan(1))
    (*observe_)(state, *S_);
}

double CvodeIntegrator::first_step(const LumpedState& state, double stop)
{
  // The first steps are of order one, with the local error h^2 |y''| / 2; y'' from a short step along y'. A
  // tenth of the step that the tolerance allows: their errors have one sign and would add up over the
  // restarts.
  const double span = stop - state.t;
  const double delta = 1e-3 * span;
  rates(state.t, state.y.data(), start_rates_.data());
  for (std::size_t i = 0; i < scratch_y_.size(); ++i) scratch_y_[i] = state.y[i] + delta * start_rates_[i];
  rates(state.t + delta, scratch_y_.data(), scratch_rates_.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < scratch_y_.size(); ++i) {
    const double tolerance = step_rtol_ * (std::abs(state.y[i]) + scale_[i]);
    const double scaled = (scratch_rates_[i] - start_rates_[i]) / (delta * tolerance);
    sum += scaled * scaled;
  }
  const double curvature = std::sqrt(sum / static_cast<double>(scratch_y_.size()));
  const double h = 0.1 * std::sqrt(2.0 / curvature);
  return h < span ? h : span;
}

void CvodeIntegrator::step_over(LumpedState& state, double stop)
{
  valve_open_ = state.valve_open;
  rates(state.t, state.y.data(), scratch_rates_.data());
  for (std::size_t i = 0; i < state.y.size(); ++i) state.y[i] += (stop - state.t) * scratch_rates_[i];
  state.t = stop;
}

void CvodeIntegrator::fail(int flag, double t, double stop) const
{
  char* name = CVodeGetReturnFlagName(flag);
  const std::string flag_name = name;
  std::free(name);
  throw SolverError(fmt::format(
      "the lumped network could not be integrated from t = {:.9g} s to {:.9g} s: {} ({}). Look for a very "
      "small inertance, resistance or compliance, or a port flow that is not finite.",
      t, stop, flag_name, message_));
}

}  // namespace valsalva::lumped
