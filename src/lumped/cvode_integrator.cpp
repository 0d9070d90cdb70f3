#include "lumped/cvode_integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/error.hpp"
#include "lumped/cvode_memory.hpp"

namespace valsalva::lumped {

namespace {

// CVODE bounds the error of each step; with a restart in every advance those errors add up with the number of
// advances. Below this length the tolerances shrink with the interval, so that the sum does not depend on the
// splitting.
constexpr double kFullToleranceInterval_s = 0.05;
constexpr double kSmallestRtol = 1e-13;

constexpr long kMostSteps = 200000;  // between two events or kinks; a heart beat takes a few hundred
constexpr int kMostSwitches = 1000;  // within one smooth piece; a heart beat has four

double absolute_scale(const std::string& unit)
{
  return unit == "ml/s" ? 10.0 : 1.0;
}

/// For calls that only fail if this file is wrong or memory is out.
void require(bool success, const char* call)
{
  if (!success)
    throw SolverError(fmt::format("{} failed while the integrator of the lumped network was set up", call));
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

  static void keep_message(int, const char*, const char*, char* message, void* user_data)
  {
    static_cast<CvodeIntegrator*>(user_data)->memory_->message = message;
  }
};

CvodeIntegrator::CvodeIntegrator(const LumpedNetwork& network, double rtol)
    : network_(network),
      rtol_(rtol),
      circuit_(network.make_circuit()),
      memory_(std::make_unique<CvodeMemory>()),
      Q_(static_cast<std::size_t>(network.port_count())),
      valve_open_(static_cast<std::size_t>(network.valve_count())),
      scratch_y_(static_cast<std::size_t>(network.state_count())),
      scratch_rates_(scratch_y_),
      start_rates_(scratch_y_),
      switched_(valve_open_)
{
  if (network.state_count() == 0) return;
  CvodeMemory& m = *memory_;
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0, "SUNContext_Create");
  m.context.reset(context);
  m.y.reset(N_VNew_Serial(network.state_count(), context));
  m.absolute_tolerance.reset(N_VNew_Serial(network.state_count(), context));
  m.cvode.reset(CVodeCreate(CV_ADAMS, context));
  require(m.y && m.absolute_tolerance && m.cvode, "CVodeCreate");
  const std::vector<StateVariable>& states = network.states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    N_VGetArrayPointer(m.y.get())[i] = states[i].initial;
    scale_.push_back(absolute_scale(states[i].unit));
    N_VGetArrayPointer(m.absolute_tolerance.get())[i] = rtol * scale_[i];
  }
  void* cvode = m.cvode.get();
  require(CVodeInit(cvode, Callbacks::rates, 0.0, m.y.get()) == CV_SUCCESS, "CVodeInit");
  require(CVodeSVtolerances(cvode, rtol, m.absolute_tolerance.get()) == CV_SUCCESS, "CVodeSVtolerances");
  m.fixed_point.reset(SUNNonlinSol_FixedPoint(m.y.get(), 0, context));
  require(m.fixed_point && CVodeSetNonlinearSolver(cvode, m.fixed_point.get()) == CV_SUCCESS,
          "CVodeSetNonlinearSolver");
  require(CVodeSetUserData(cvode, this) == CV_SUCCESS, "CVodeSetUserData");
  require(CVodeSetErrHandlerFn(cvode, Callbacks::keep_message, this) == CV_SUCCESS, "CVodeSetErrHandlerFn");
  require(CVodeSetMaxNumSteps(cvode, kMostSteps) == CV_SUCCESS, "CVodeSetMaxNumSteps");
  if (network.valve_count() > 0) {
    require(CVodeRootInit(cvode, network.valve_count(), Callbacks::switch_margins) == CV_SUCCESS,
            "CVodeRootInit");
    std::vector<int> downward(valve_open_.size(), -1);
    require(CVodeSetRootDirection(cvode, downward.data()) == CV_SUCCESS, "CVodeSetRootDirection");
    require(CVodeSetNoInactiveRootWarn(cvode) == CV_SUCCESS, "CVodeSetNoInactiveRootWarn");
  }
}

CvodeIntegrator::~CvodeIntegrator() = default;

void CvodeIntegrator::advance(LumpedState& state, double t_end, std::span<const double> Q_begin,
                              std::span<const double> Q_end)
{
  if (!(t_end >= state.t))
    throw SolverError(
        fmt::format("the lumped network stands at t = {} s and cannot go back to {} s", state.t, t_end));
  if (Q_begin.size() != Q_.size() || Q_end.size() != Q_.size())
    throw SolverError(fmt::format("the lumped network has {} ports, but {} and {} port flows were given",
                                  Q_.size(), Q_begin.size(), Q_end.size()));
  t_begin_ = state.t;
  t_end_ = t_end;
  Q_begin_ = Q_begin;
  Q_end_ = Q_end;
  set_tolerances(t_end - state.t);
  LumpedState next = state;
  while (next.t < t_end) {
    const double kink = network_.next_kink(next.t);
    advance_smooth_piece(next, kink < t_end - kTimeResolution_s ? kink : t_end);
  }
  state = std::move(next);
}

void CvodeIntegrator::set_tolerances(double interval)
{
  step_rtol_ =
      std::max(rtol_ * std::min(1.0, interval / kFullToleranceInterval_s), std::min(rtol_, kSmallestRtol));
  for (std::size_t i = 0; i < scale_.size(); ++i)
    N_VGetArrayPointer(memory_->absolute_tolerance.get())[i] = step_rtol_ * scale_[i];
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
  const auto settle = [&] {
    set_port_flows(state.t);
    statistics_.events += network_.settle_valves({state.t, piece_}, state, Q_, circuit_);
  };
  settle();
  for (int switches = 0; stop - state.t > kTimeResolution_s && network_.state_count() > 0; ++switches) {
    if (switches > kMostSwitches)
      throw SolverError(
          fmt::format("the valves of the lumped network switched more than {} times up to t = {} s; a "
                      "valve flutters. Give it an inertance or a larger resistance.",
                      kMostSwitches, state.t));
    if (run_cvode(state, stop)) settle();
  }
  if (state.t < stop) {
    step_over(state, stop);
    settle();
  }
}

bool CvodeIntegrator::run_cvode(LumpedState& state, double stop)
{
  CvodeMemory& m = *memory_;
  void* cvode = m.cvode.get();
  valve_open_ = state.valve_open;
  double* y = N_VGetArrayPointer(m.y.get());
  std::copy(state.y.begin(), state.y.end(), y);

  int flag = CVodeReInit(cvode, state.t, m.y.get());
  if (flag == CV_SUCCESS) flag = CVodeSVtolerances(cvode, step_rtol_, m.absolute_tolerance.get());
  if (flag == CV_SUCCESS) flag = CVodeSetInitStep(cvode, first_step(state, stop));
  if (flag == CV_SUCCESS) flag = CVodeSetStopTime(cvode, stop);
  double t = state.t;
  if (flag == CV_SUCCESS) flag = CVode(cvode, stop, m.y.get(), &t, CV_NORMAL);
  if (flag < 0) fail(flag, t, stop);
  long steps = 0;
  CVodeGetNumSteps(cvode, &steps);
  statistics_.steps += steps;

  std::copy(y, y + state.y.size(), state.y.begin());
  state.t = flag == CV_ROOT_RETURN ? t : stop;
  if (flag != CV_ROOT_RETURN) return false;
  CVodeGetRootInfo(cvode, switched_.data());
  for (std::size_t v = 0; v < switched_.size(); ++v)
    if (switched_[v] != 0) {
      network_.switch_valve(static_cast<int>(v), state);
      ++statistics_.events;
    }
  return true;
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
      t, stop, flag_name, memory_->message));
}

}  // namespace valsalva::lumped
