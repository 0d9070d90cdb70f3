#include "coupling/coupled_model.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/error.hpp"
#include "common/units.hpp"

namespace valsalva::coupling {

namespace {

/// A step may grow by this factor over the one before it, so that the multistep weights stay mild.
constexpr double kGrowth = 1.15;
/// Beyond this CFL number a step has blown up.
constexpr double kBlowUpCfl = 2.0;

Eigen::VectorXd as_vector(const std::vector<double>& v)
{
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

std::vector<double> in_dyn_cm2(const Eigen::VectorXd& p_mmHg)
{
  std::vector<double> p(static_cast<std::size_t>(p_mmHg.size()));
  for (std::size_t m = 0; m < p.size(); ++m)
    p[m] = common::dyn_cm2_from_mmHg(p_mmHg[static_cast<Eigen::Index>(m)]);
  return p;
}

}  // namespace

CoupledModel::CoupledModel(ib3d::ImmersedBoundarySolver& solver, Circulation& circulation,
                           CouplingScheme scheme, const StepControl& control, Timers& timers)
    : solver_(solver), circulation_(circulation), scheme_(scheme), control_(control), timers_(timers)
{
  const std::vector<double> none(static_cast<std::size_t>(circulation.port_count()), 0.0);
  interface_ = {circulation.state().t, circulation.pressures(none), none};
  flow_before_ = kinetic_outflow_ = none;
  solver_.seed_markers(t());
}

Eigen::MatrixXd CoupledModel::conductance() const
{
  return common::kMmHg * solver_.fluid().modes().conductance();
}

double CoupledModel::inertance(int m) const
{
  return 1 / conductance()(m, m);
}

ib3d::StepBound CoupledModel::next_step(double t_stop)
{
  ib3d::StepBound bound{control_.dt_max_s, ib3d::Limit::longest};
  const auto limit = [&](double dt, ib3d::Limit by) {
    if (dt < bound.dt) bound = {dt, by};
  };
  const double omega = solver_.elastic_rate();
  if (control_.dt_fixed_s > 0) {
    if (control_.dt_fixed_s * omega > 2)
      throw SolverError(
          fmt::format("time.dt_fixed_s = {:.3g} s is beyond the structure's stable step of {:.3g} s; use a "
                      "smaller one, or 0 for automatic steps",
                      control_.dt_fixed_s, 2 / omega));
    bound = {control_.dt_fixed_s, ib3d::Limit::fixed};
  } else {
    // Adams-Bashforth has one stretch of the real axis for convection and viscosity together: the rates add.
    const double viscous_rate =
        1 / ib3d::viscous_step_limit(solver_.fluid().grid().finest(), solver_.fluid().fluid());
    limit(1 / viscous_rate, ib3d::Limit::viscous);
    limit(1 / (solver_.courant_rate() / control_.cfl + viscous_rate), ib3d::Limit::cfl);
    if (omega > 0) limit(control_.elastic_safety * 2 / omega, ib3d::Limit::elastic);
    if (dt_before_ > 0) limit(kGrowth * dt_before_, ib3d::Limit::growth);
  }
  const double left = std::min(t_stop, circulation_.network().next_kink(t())) - t();
  const double steps = std::ceil(left / bound.dt * (1 - 1e-9));
  if (steps <= 20) limit(left / std::max(1.0, steps), ib3d::Limit::target);
  return bound;
}

/// Mean opening pressures over the step to come, for the flow extrapolated (implicit) or frozen (explicit).
void CoupledModel::predict_pressures(double dt)
{
  const Eigen::VectorXd Q = as_vector(interface_.flow_ml_s);
  if (scheme_ == CouplingScheme::explicit_) {
    p_used_ = as_vector(circulation_.pressures(interface_.flow_ml_s));
    return;
  }
  const double ratio = dt_before_ > 0 ? dt / dt_before_ : 0;
  const Eigen::VectorXd Q_guess = Q + ratio * (Q - as_vector(flow_before_));
  p_used_ = circulation_.mean_pressures(dt, interface_.flow_ml_s, Q_guess);
}

/// Numbers refer to docs/scheme.md.
StepReport CoupledModel::advance(const ib3d::StepBound& step)
{
  const double dt = step.dt;
  solver_.begin_step(dt);  // (2.1)-(2.5): F = F[X], f = S F, u*

  predict_pressures(dt);                                                           // (4.1)
  const Eigen::VectorXd Q0 = as_vector(solver_.solve_fluid(in_dyn_cm2(p_used_)));  // (3.1), (4.2)
  const Eigen::MatrixXd G = dt * conductance();
  Eigen::VectorXd phi = Eigen::VectorXd::Zero(Q0.size());
  if (scheme_ == CouplingScheme::implicit_) {
    const auto scope = timers_.time("circulation");
    phi = circulation_.close(dt, interface_.flow_ml_s, Q0, G, p_used_);  // (4.3)
  }
  solver_.accept(in_dyn_cm2(phi));  // (3.2), (2.6): u^{n+1}, X^{n+1}

  const Eigen::VectorXd Q = Q0 - G * phi;
  check_numbers(dt, Q);
  flow_before_ = interface_.flow_ml_s;
  interface_.flow_ml_s.assign(Q.data(), Q.data() + Q.size());
  account_energy(dt, p_used_ + phi);
  const bool implicit = scheme_ == CouplingScheme::implicit_;
  circulation_.advance(dt, implicit ? flow_before_ : interface_.flow_ml_s, interface_.flow_ml_s);  // (4.4)
  interface_.t_s = t();
  interface_.pressure_mmHg = circulation_.pressures(interface_.flow_ml_s);
  solver_.seed_markers(t());
  dt_before_ = dt;
  ++step_;
  const ib3d::NavierStokes& fluid = solver_.fluid();
  return {step_,
          t(),
          dt,
          step.limited_by,
          solver_.courant_rate() * dt,
          fluid.pressure_report().iterations,
          fluid.divergence_rms(),
          fluid.divergence_max()};
}

/// (4.6), with p the opening pressures of the step just taken.
void CoupledModel::account_energy(double dt, const Eigen::VectorXd& p)
{
  std::vector<double> kinetic = solver_.fluid().kinetic_outflow();
  for (std::size_t m = 0; m < kinetic.size(); ++m) {
    pressure_work_ -=
        0.5 * dt * p[static_cast<Eigen::Index>(m)] * (flow_before_[m] + interface_.flow_ml_s[m]);
    kinetic_inflow_ -= 0.5 * dt * common::mmHg_from_dyn_cm2(kinetic_outflow_[m] + kinetic[m]);
  }
  kinetic_outflow_ = std::move(kinetic);
}

void CoupledModel::save_or_restore(Checkpoint& c)
{
  c("coupling/pressure_work_mmHg_ml", pressure_work_);
  c("coupling/kinetic_inflow_mmHg_ml", kinetic_inflow_);
  c("coupling/kinetic_outflow_erg_s", kinetic_outflow_);
  c("coupling/step", step_);
  c("coupling/dt_before_s", dt_before_);
  c("coupling/t_s", interface_.t_s);
  c("coupling/pressure_mmHg", interface_.pressure_mmHg);
  c("coupling/flow_ml_s", interface_.flow_ml_s);
  c("coupling/flow_before_ml_s", flow_before_);
  circulation_.save_or_restore(c);
  solver_.save_or_restore(c);
}

void CoupledModel::check_numbers(double dt, const Eigen::VectorXd& Q) const
{
  const double cfl = solver_.courant_rate() * dt;
  if (std::isfinite(cfl) && cfl <= kBlowUpCfl && Q.allFinite()) return;
  throw SolverError(fmt::format(
      "the velocity has blown up (CFL number {:.3g} after a step of {:.3g} s); use a smaller {}", cfl, dt,
      control_.dt_fixed_s > 0 ? "time.dt_fixed_s, or 0 for automatic steps"
                              : "time.cfl or time.elastic_safety"));
}

}  // namespace valsalva::coupling
