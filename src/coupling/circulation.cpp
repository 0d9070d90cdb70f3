#include "coupling/circulation.hpp"

#include <fmt/format.h>

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

}  // namespace

Circulation::Circulation(const lumped::NetworkSpec& spec)
    : network_(spec), integrator_(network_), state_(network_.initial_state())
{
}

Circulation::Circulation(const lumped::NetworkSpec& spec, lumped::LumpedState start)
    : network_(spec), integrator_(network_), state_(std::move(start))
{
}

Eigen::VectorXd Circulation::mean_pressures(double dt, const std::vector<double>& Q,
                                            const Eigen::VectorXd& Q_end)
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
    resistance_.col(k) = (mean_pressures(dt, Q, moved) - p_end) / kFlowDifference_ml_s;
  }
  resistance_dt_ = dt;
}

Eigen::VectorXd Circulation::close(double dt, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                                   const Eigen::MatrixXd& G, const Eigen::VectorXd& p_used)
{
  const auto identity = Eigen::MatrixXd::Identity(Q0.size(), Q0.size());
  Eigen::VectorXd phi = Eigen::VectorXd::Zero(Q0.size());
  Eigen::VectorXd p = mean_pressures(dt, Q, Q0);
  Eigen::VectorXd residual = p - p_used;
  bool fresh = false;
  for (int iteration = 0; residual.cwiseAbs().maxCoeff() > kTolerance_mmHg; ++iteration) {
    if (iteration == kMostIterations)
      throw SolverError(
          fmt::format("the circulation does not answer to the 3D flow: {:.3g} mmHg are left after {} "
                      "iterations",
                      residual.cwiseAbs().maxCoeff(), kMostIterations));
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
      p = mean_pressures(dt, Q, Q0 - G * phi);
      residual = p - p_used - phi;
      if (residual.norm() < before || halvings == 0) break;
    }
  }
  return phi;
}

void Circulation::advance(double dt, const std::vector<double>& Q, const std::vector<double>& Q_end)
{
  integrator_.advance(state_, state_.t + dt, Q, Q_end);
}

void Circulation::save_or_restore(Checkpoint& c)
{
  c("circulation/t_s", state_.t);
  c("circulation/y", state_.y);
  c("circulation/valve_open", state_.valve_open);
  std::vector<double> resistance(resistance_.data(), resistance_.data() + resistance_.size());
  c("circulation/resistance_mmHg_s_ml", resistance);
  c("circulation/resistance_dt_s", resistance_dt_);
  c("circulation/evaluations", evaluations_);
  const Eigen::Index n = resistance.empty() ? 0 : port_count();
  resistance_ = Eigen::Map<const Eigen::MatrixXd>(resistance.data(), n, n);
}

}  // namespace valsalva::coupling
