// Flexible conjugate gradients for the pressure problem on all levels, with a preconditioner that may vary from call
// to call (beta in the Polak-Ribiere form; Golub & Ye 1999). Mixed precision: residual, direction and A d are single,
// p is double; when the residual has fallen by 1e-4 it is recomputed from p in double, so that any tolerance can be
// reached. Inner products and norms weigh a cell with its volume.
#pragma once

#include <functional>

#include "ib3d/fluid/pressure/composite_pressure.hpp"
#include "ib3d/fluid/pressure/preconditioner.hpp"

namespace valsalva::ib3d {

/// Units of p/cm^2.
struct KrylovReport {
  int iterations = 0;
  double initial_rms = 0, final_rms = 0;  ///< root mean square of the residual b + lap p before and after
  double final_max = 0;                   ///< largest residual afterwards
};

class FlexibleCg {
 public:
  /// Both must outlive the object.
  FlexibleCg(CompositePressure& problem, Preconditioner& preconditioner);

  /// Improves p until rms(r) <= tolerance_rms (units of p/cm^2), tested before the first iteration too. `residual`
  /// fills its argument with h^2 r for the current p, zero on covered cells. On a singular grid the mean of r is
  /// removed. Collective. Throws SolverError when `max_iterations` do not suffice or a number is not finite.
  KrylovReport solve(CompositeCells<double>& p, const std::function<void(CompositeCells<float>&)>& residual,
                     double tolerance_rms, int max_iterations);

 private:
  /// Iterates until rms <= target; returns the rms reached.
  double iterate(CompositeCells<double>& p, double rms, double target, int max_iterations,
                 KrylovReport& report);
  double rms() const;
  double largest() const;
  void remove_mean();
  double sum_over_ranks(double local) const;

  CompositePressure& problem_;
  Preconditioner& preconditioner_;
  const Hierarchy& grid_;
  double volume_ = 0;  ///< of the domain, cm^3
  CompositeCells<float> r_, direction_, z_, a_direction_;
};

}  // namespace valsalva::ib3d
