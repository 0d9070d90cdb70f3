#include "coupling/circulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/error.hpp"

namespace valsalva::coupling {

namespace {

constexpr double kTolerance_mmHg = 1e-8;
constexpr double kFlowDifference_ml_s = 1.0;
constexpr int kKeptResistance = 3;  ///< iterations before dp/dQ is renewed
constexpr int kMostIterations = 40;

std::vector<double> plain(const Eigen::VectorXd& v)
{
  return {v.data(), v.data() + v.size()};
}

double largest(const Eigen::VectorXd& v)
{
  return v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace

Circulation::Circulation(const lumped::NetworkSpec& spec, const Communicator& comm)
    : Circulation(spec, lumped::LumpedNetwork(spec).initial_state(), comm)
{
}

Circulation::Circulation(const lumped::NetworkSpec& spec, lumped::LumpedState start, const Communicator& comm)
    : comm_(comm), network_(spec), integrator_(network_), state_(std::move(start))
{
  share_state([] {});
}

/// What `work` gives on rank 0, one number per port.
Eigen::VectorXd Circulation::from_rank_0(const std::function<Eigen::VectorXd()>& work) const
{
  std::vector<double> values(static_cast<std::size_t>(port_count()));
  common::on_rank_0(
      comm_, [&] { values = plain(work()); }, values);
  return Eigen::Map<Eigen::VectorXd>(values.data(), port_count());
}

/// The state of rank 0 after `work`.
void Circulation::share_state(const std::function<void()>& work)
{
  const std::size_t states = state_.y.size();
  std::vector<double> values(1 + states + state_.valve_open.size());
  const auto pack = [&] {
    work();
    values[0] = state_.t;
    std::copy(state_.y.begin(), state_.y.end(), values.begin() + 1);
    std::copy(state_.valve_open.begin(), state_.valve_open.end(),
              values.end() - std::ssize(state_.valve_open));
  };
  common::on_rank_0(comm_, pack, values);
  state_.t = values[0];
  for (std::size_t i = 0; i < states; ++i) state_.y[i] = values[1 + i];
  for (std::size_t v = 0; v < state_.valve_open.size(); ++v)
    state_.valve_open[v] = values[1 + states + v] != 0.0 ? 1 : 0;
}

std::vector<double> Circulation::pressures(const std::vector<double>& Q) const
{
  std::vector<double> p(Q.size());
  common::on_rank_0(
      comm_, [&] { p = network_.port_pressures(state_, Q); }, p);
  return p;
}

Eigen::VectorXd Circulation::mean_pressures(double dt, const std::vector<double>& Q,
                                            const Eigen::VectorXd& Q_end)
{
  return from_rank_0([&] { return integrate(dt, Q, Q_end); });
}

Eigen::VectorXd Circulation::close(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                                   const Eigen::MatrixXd& G, const Eigen::VectorXd& p_used)
{
  return from_rank_0([&] { return solve_closure(dt, Q, Q0, G, p_used); });
}

void Circulation::advance(double dt, const std::vector<double>& Q, const std::vector<double>& Q_end)
{
  share_state([&] { integrator_.advance(state_, state_.t + dt, Q, Q_end); });
}

Eigen::VectorXd Circulation::integrate(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q_end)
{
  ++evaluations_;
  lumped::LumpedState end = state_;
  const std::vector<double> Q1 = plain(Q_end);
  const std::vector<double> p0 = network_.port_pressures(state_, Q);
  integrator_.advance(end, state_.t + dt, Q, Q1);
  const std::vector<double> p1 = network_.port_pressures(end, Q1);
  Eigen::VectorXd mean(p0.size());
  for (std::size_t m = 0; m < p0.size(); ++m) mean[static_cast<Eigen::Index>(m)] = 0.5 * (p0[m] + p1[m]);
  return mean;
}

void Circulation::update_resistance(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q_end,
                                    const Eigen::VectorXd& p_end)
{
  resistance_.resize(Q_end.size(), Q_end.size());
  for (Eigen::Index k = 0; k < Q_end.size(); ++k) {
    Eigen::VectorXd moved = Q_end;
    moved[k] += kFlowDifference_ml_s;
    resistance_.col(k) = (integrate(dt, Q, moved) - p_end) / kFlowDifference_ml_s;
  }
  resistance_dt_ = dt;
}

Eigen::VectorXd Circulation::solve_closure(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                                           const Eigen::MatrixXd& G, const Eigen::VectorXd& p_used)
{
  const auto identity = Eigen::MatrixXd::Identity(Q0.size(), Q0.size());
  Eigen::VectorXd phi = Eigen::VectorXd::Zero(Q0.size());
  Eigen::VectorXd p = integrate(dt, Q, Q0);
  Eigen::VectorXd residual = p - p_used;
  bool fresh = false;
  for (int iteration = 0; !(largest(residual) <= kTolerance_mmHg); ++iteration) {
    if (iteration == kMostIterations)
      throw SolverError(
          fmt::format("3D-0D coupling did not converge: residual {:.3g} mmHg after {} iterations",
                      largest(residual), kMostIterations));
    if (resistance_.rows() != Q0.size() || resistance_dt_ != dt || iteration >= kKeptResistance) {
      update_resistance(dt, Q, Q0 - G * phi, p);
      fresh = true;
    }
    const Eigen::VectorXd step = (identity + resistance_ * G).partialPivLu().solve(residual);
    // A switching valve inside the step makes p(Q) kinked: halve the step while it makes things worse.
    const Eigen::VectorXd start = phi;
    const double before = residual.norm();
    double share = 1;
    for (int halvings = fresh ? 10 : 0;; --halvings, share *= 0.5) {
      phi = start + share * step;
      p = integrate(dt, Q, Q0 - G * phi);
      residual = p - p_used - phi;
      if (residual.norm() < before || halvings == 0) break;
    }
  }
  return phi;
}

void Circulation::save_or_restore(Checkpoint& c)
{
  c("circulation/t_s", state_.t);
  c("circulation/y", state_.y);
  c("circulation/valve_open", state_.valve_open);
  std::vector<double> resistance(resistance_.data(), resistance_.data() + resistance_.size());
  resistance.resize(static_cast<std::size_t>(comm_.from_rank_0(static_cast<double>(resistance.size()))));
  c("circulation/resistance_mmHg_s_ml", resistance);
  c("circulation/resistance_dt_s", resistance_dt_);
  long evaluations = evaluations_;
  c("circulation/evaluations", evaluations);
  if (comm_.is_rank_0()) evaluations_ = evaluations;
  const Eigen::Index n = resistance.empty() ? 0 : port_count();
  resistance_ = Eigen::Map<const Eigen::MatrixXd>(resistance.data(), n, n);
}

}  // namespace valsalva::coupling
