// Nonlinear least squares with bounds: minimises |r(x)|^2 by Levenberg's and Marquardt's damped Gauss-Newton
// steps
//     (J^T J + lambda D^2) d = -J^T r,     D = column norms of J,
// on the unknowns that are free: one at its bound that the gradient pushes outward is held there. (Eigen's own
// implementation knows no bounds.) Source: More, in: Numerical Analysis, Lecture Notes in Mathematics 630
// (1978) 105-116; projection: Bertsekas, SIAM J Control Optim 20 (1982) 221-246.
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace valsalva::lumped {

/// r(x) and J = dr/dx. May throw SolverError where the model has no answer: the step is then shortened.
using Residuals = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J)>;

/// Unknowns, residuals and their derivatives where the search ended.
struct LeastSquares {
  Eigen::VectorXd x, r;
  Eigen::MatrixXd J;
  int evaluations = 0;
  bool converged = false;  ///< false: the limit of evaluations was met
};

struct LeastSquaresOptions {
  double step_tolerance = 1e-10;  ///< in x, which is a logarithm or scaled to 1
  int most_evaluations = 100;
};

/// From x, which is moved within lowest <= x <= highest (one entry per unknown). Passes on what
/// `residuals` throws at the start.
LeastSquares levenberg_marquardt(const Residuals& residuals, Eigen::VectorXd x, const Eigen::VectorXd& lowest,
                                 const Eigen::VectorXd& highest, const LeastSquaresOptions& options = {});

}  // namespace valsalva::lumped
