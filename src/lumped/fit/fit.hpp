// Fits free parameters of a network to measured traces and summary numbers by trajectory least squares (output
// error, never differentiated data), and says what the data determine and what they do not. With the weighted
// residuals r and J = dr/dx at the optimum,
//     covariance of x = s^2 (J^T J)^{-1},   s^2 = |r|^2/(m - n) where the measurements' sd is unknown, else 1.
// A logarithmic unknown has sd(p) = p sd(x) and the interval p exp(+-1.96 sd(x)). All this takes independent
// residuals for granted; their correlation in time is reported beside it.
// Source: Seber & Wild, Nonlinear Regression, Wiley 1989, chapters 2, 3 and 5; identifiability by singular
// values: Belsley, Kuh & Welsch, Regression Diagnostics, Wiley 1980, chapter 3.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "lumped/fit/fit_problem.hpp"

namespace valsalva::lumped {

/// One unknown; start, value and bounds are of the quantity itself.
struct Estimate {
  std::string name;
  double start, value;
  double sd;               ///< infinite if the data do not determine it
  double lowest, highest;  ///< 95 % interval
  double relative_sd;      ///< sd of the logarithm, or of a linear unknown sd/|value|
  bool at_bound;
};

/// How well one signal or summary is met.
struct FitQuality {
  std::string name;
  std::vector<double> t, data, model;  ///< a summary has one entry, its time is 0
  double rms;                          ///< of model - data
  double lag_one;                      ///< correlation of neighbouring residuals of a signal
};

/// The optimum with what is known about it; matrices have one row and column per estimate.
struct Fit {
  std::vector<Estimate> estimates;
  Eigen::MatrixXd correlation;
  std::vector<FitQuality> signals, summaries;
  int residual_count = 0;
  int rank = 0;                     ///< of the information matrix J^T J
  double condition = 0.0;           ///< of the information matrix
  Eigen::MatrixXd free_directions;  ///< per column a direction of x along which the residuals do not change
  double chi_squared = 0.0;         ///< |r|^2
  bool sd_is_known = false;
  bool converged = false;
  int evaluations = 0;
  std::vector<std::string> flags;  ///< sentences on what the data cannot tell
  NetworkSpec network;             ///< with the fitted parameters
};

/// CaseError if the problem makes no sense; SolverError if the model has no answer at the start.
Fit fit(const FitProblem& problem);

}  // namespace valsalva::lumped
