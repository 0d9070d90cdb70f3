#include "lumped/fit/levenberg_marquardt.hpp"

#include <algorithm>
#include <vector>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"

namespace valsalva::lumped {

namespace {

constexpr double kFirstDamping = 1e-3, kSmallestDamping = 1e-12, kLargestDamping = 1e12;

/// Which unknowns may move: not those at a bound that the descent direction would leave.
std::vector<Eigen::Index> free_unknowns(const LeastSquares& at, const Eigen::VectorXd& lowest,
                                        const Eigen::VectorXd& highest)
{
  const Eigen::VectorXd descent = -at.J.transpose() * at.r;
  std::vector<Eigen::Index> free;
  for (Eigen::Index j = 0; j < at.x.size(); ++j)
    if (!(at.x[j] <= lowest[j] && descent[j] < 0.0) && !(at.x[j] >= highest[j] && descent[j] > 0.0))
      free.push_back(j);
  return free;
}

/// The damped step, by least squares on [J; sqrt(lambda) D].
Eigen::VectorXd damped_step(const LeastSquares& at, const std::vector<Eigen::Index>& free, double damping)
{
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(at.r.size() + count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(at.r.size() + count);
  right.head(at.r.size()) = -at.r;
  const double largest = at.J.colwise().norm().maxCoeff<Eigen::PropagateNaN>();
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto column = at.J.col(free[static_cast<std::size_t>(k)]);
    matrix.col(k).head(at.r.size()) = column;
    matrix(at.r.size() + k, k) = std::sqrt(damping) * max_or_nan(column.norm(), 1e-6 * largest);
  }
  const Eigen::VectorXd step = matrix.householderQr().solve(right);
  Eigen::VectorXd full = Eigen::VectorXd::Zero(at.x.size());
  for (Eigen::Index k = 0; k < count; ++k) full[free[static_cast<std::size_t>(k)]] = step[k];
  return full;
}

}  // namespace

LeastSquares levenberg_marquardt(const Residuals& residuals, Eigen::VectorXd x, const Eigen::VectorXd& lowest,
                                 const Eigen::VectorXd& highest, const LeastSquaresOptions& options)
{
  LeastSquares at;
  at.x = x.cwiseMax(lowest).cwiseMin(highest);
  residuals(at.x, at.r, at.J);
  at.evaluations = 1;
  LeastSquares trial = at;
  double damping = kFirstDamping;
  while (at.evaluations < options.most_evaluations) {
    const std::vector<Eigen::Index> free = free_unknowns(at, lowest, highest);
    if (!free.empty()) trial.x = (at.x + damped_step(at, free, damping)).cwiseMax(lowest).cwiseMin(highest);
    const double length = (trial.x - at.x).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    if (free.empty() || length <= options.step_tolerance || damping > kLargestDamping) {
      at.converged = true;
      return at;
    }
    ++at.evaluations;
    bool is_better = false;
    try {
      residuals(trial.x, trial.r, trial.J);
      is_better = trial.r.squaredNorm() < at.r.squaredNorm();
    } catch (const SolverError&) {
    }
    if (is_better) {
      std::swap(at.x, trial.x);
      std::swap(at.r, trial.r);
      std::swap(at.J, trial.J);
      damping = std::max(0.1 * damping, kSmallestDamping);
    } else {
      damping *= 10.0;
    }
    trial.x = at.x;
  }
  return at;
}

}  // namespace valsalva::lumped
