#include "lumped/fit/fit.hpp"

#include <cmath>

#include "lumped/fit/fit_flags.hpp"
#include "lumped/fit/fit_model.hpp"
#include "lumped/fit/levenberg_marquardt.hpp"

namespace valsalva::lumped {

namespace {

constexpr double kRankTolerance = 1e-6;  // of the largest singular value; gradients are good to 1e-7
constexpr double k95Percent = 1.959964;

Eigen::VectorXd in_x(const std::vector<Unknown>& unknowns, double Unknown::*member)
{
  Eigen::VectorXd x(static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    x[static_cast<Eigen::Index>(k)] = unknowns[k].to_x(unknowns[k].*member);
  return x;
}

/// Rank, condition, covariance and correlation from the singular values of J.
Eigen::MatrixXd statistics(const Eigen::MatrixXd& J, double s_squared, Fit& result)
{
  // Columns scaled to 1: the rank is not to depend on the units of a linear unknown.
  const Eigen::Index n = J.cols();
  Eigen::VectorXd scale = J.colwise().norm();
  const double largest = scale.maxCoeff<Eigen::PropagateNaN>();
  for (Eigen::Index k = 0; k < n; ++k)
    if (scale[k] <= kRankTolerance * largest) scale[k] = largest;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J * scale.cwiseInverse().asDiagonal(),
                                              Eigen::ComputeThinU | Eigen::ComputeFullV);
  Eigen::VectorXd singular = Eigen::VectorXd::Zero(n);
  singular.head(svd.singularValues().size()) = svd.singularValues();
  result.rank = static_cast<int>((singular.array() > kRankTolerance * singular[0]).count());
  result.condition = std::pow(singular[0] / singular[n - 1], 2);
  const Eigen::MatrixXd V = scale.cwiseInverse().asDiagonal() * svd.matrixV();
  result.free_directions = V.rightCols(n - result.rank);
  for (Eigen::Index c = 0; c < result.free_directions.cols(); ++c)
    result.free_directions.col(c) /= result.free_directions.col(c).cwiseAbs().maxCoeff();
  const Eigen::MatrixXd determined =
      V.leftCols(result.rank) * singular.head(result.rank).cwiseInverse().asDiagonal();
  Eigen::MatrixXd covariance = s_squared * determined * determined.transpose();
  const Eigen::VectorXd sd = covariance.diagonal().cwiseSqrt();
  result.correlation = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = 0; b < n; ++b)
      if (a != b && sd[a] > 0.0 && sd[b] > 0.0) result.correlation(a, b) = covariance(a, b) / (sd[a] * sd[b]);
  // What a free direction moves is not determined at all.
  for (Eigen::Index k = 0; k < n; ++k)
    if (result.free_directions.cols() > 0 && result.free_directions.row(k).cwiseAbs().maxCoeff() > 1e-3)
      covariance(k, k) = std::numeric_limits<double>::infinity();
  return covariance;
}

Estimate estimate_of(const Unknown& u, double x, double sd_of_x)
{
  Estimate e{u.name, u.start, u.from_x(x), sd_of_x, 0.0, 0.0, sd_of_x, false};
  if (u.is_log)
    e.sd = e.value * sd_of_x;
  else
    e.relative_sd = sd_of_x / std::abs(e.value);
  e.lowest = u.from_x(x - k95Percent * sd_of_x);
  e.highest = u.from_x(x + k95Percent * sd_of_x);
  const double near = 1e-9 * std::abs(e.value);
  e.at_bound = (e.value <= u.lowest + near && u.lowest > 0.0) || e.value >= u.highest - near;
  return e;
}

/// Model and data of n residuals from `first` on, which are (model - data)/sd.
FitQuality quality(const std::string& name, const std::vector<double>& t, const std::vector<double>& data,
                   const Eigen::VectorXd& residuals)
{
  FitQuality q{name, t, data, {}, 0.0, 0.0};
  const Eigen::Index n = residuals.size();
  for (Eigen::Index i = 0; i < n; ++i) q.model.push_back(data[static_cast<std::size_t>(i)] + residuals[i]);
  const double square = residuals.squaredNorm();
  q.rms = std::sqrt(square / static_cast<double>(n));
  if (n > 1 && square > 0.0) q.lag_one = residuals.head(n - 1).dot(residuals.tail(n - 1)) / square;
  return q;
}

}  // namespace

Fit fit(const FitProblem& problem)
{
  FitModel model(problem);
  const std::vector<Unknown>& unknowns = model.unknowns();
  const LeastSquares least = levenberg_marquardt(
      [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J) { model.evaluate(x, r, J); },
      in_x(unknowns, &Unknown::start), in_x(unknowns, &Unknown::lowest), in_x(unknowns, &Unknown::highest));

  Fit result;
  result.converged = least.converged;
  result.evaluations = least.evaluations;
  result.residual_count = static_cast<int>(least.r.size());
  result.chi_squared = least.r.squaredNorm();
  result.sd_is_known = model.sd_is_known();
  const Eigen::Index freedom = least.r.size() - least.x.size();
  const double s_squared =
      result.sd_is_known || freedom <= 0 ? 1.0 : result.chi_squared / static_cast<double>(freedom);
  const Eigen::MatrixXd covariance = statistics(least.J, s_squared, result);

  result.network = problem.network;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    result.estimates.push_back(estimate_of(unknowns[k], least.x[i], std::sqrt(covariance(i, i))));
    if (k < problem.parameters.size())
      parameter_of(result.network, unknowns[k].name) = result.estimates.back().value;
  }
  Eigen::Index first = 0;
  for (std::size_t s = 0; s < problem.signals.size(); ++s) {
    const FitSignal& signal = problem.signals[s];
    const auto n = static_cast<Eigen::Index>(signal.t.size());
    result.signals.push_back(
        quality(signal.name, signal.t, signal.value, model.sd(s) * least.r.segment(first, n)));
    first += n;
  }
  for (const FitSummary& summary : problem.summaries)
    result.summaries.push_back(
        quality(summary.name, {0.0}, {summary.value}, summary.sd * least.r.segment(first++, 1)));
  result.flags = data_flags(problem);
  for (const std::string& flag : fit_flags(result, unknowns)) result.flags.push_back(flag);
  return result;
}

}  // namespace valsalva::lumped
