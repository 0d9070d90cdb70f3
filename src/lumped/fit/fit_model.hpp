// The weighted residuals of a fit and their exact derivatives. The unknowns x are, in this order,
//   the parameters: as logarithms where the element type allows no negative values, else as they are;
//   per signal with a baseline its constant, per signal with a shift its time (s).
// A residual is (model - data)/sd; the model of a signal is  observable(t + shift) + baseline  on the periodic
// state found by shooting for the parameters of x. The search for it starts at the last one found.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "lumped/fit/fit_problem.hpp"
#include "lumped/integration/limit_cycle.hpp"

namespace valsalva::lumped {

/// One component of x.
struct Unknown {
  std::string name;
  bool is_log;
  double start, lowest, highest;  ///< of the quantity itself
  /// The quantity as a component of x, its logarithm or itself, and back.
  double to_x(double value) const;
  double from_x(double x) const;
};

class FitModel {
 public:
  /// CaseError if a name, a bound or a number of the problem makes no sense.
  explicit FitModel(const FitProblem& problem);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  /// Residuals: the signals one after the other, then the summaries.
  void evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J);
  /// The residuals' standard deviation as the problem gives it; 1 where it is unknown.
  double sd(std::size_t signal) const;
  bool sd_is_known() const;

 private:
  struct Place {
    Eigen::Index baseline = -1, shift = -1;
  };
  void add_parameters();
  void check_observables() const;
  LimitCycle beginning(const NetworkSpec& spec);
  double model_time(double t) const;

  FitProblem problem_;
  std::vector<Unknown> unknowns_;
  std::vector<std::string> parameters_, observables_;
  std::vector<Place> places_;  ///< per signal
  std::optional<LumpedState> guess_;
};

}  // namespace valsalva::lumped
