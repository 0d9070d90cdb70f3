// Flexible conjugate gradients for the pressure problem  -lap p = b  on one grid, with a preconditioner that
// may vary from call to call (beta in the Polak-Ribiere form; Golub & Ye 1999).
#pragma once

#include "ib3d/fluid/preconditioner.hpp"
#include "ib3d/fluid/pressure_grid.hpp"

namespace valsalva::ib3d {

struct KrylovReport {
  int iterations = 0;
  double initial_rms = 0, final_rms = 0;  ///< root mean square of the residual before and after
  double final_max = 0;                   ///< largest residual afterwards
};

class FlexibleCg {
 public:
  FlexibleCg(const PressureGrid& grid, Preconditioner& preconditioner);

  /// Improves p until rms(r) <= tolerance_rms, where r enters as the residual b + lap p (units of p/cm^2) and
  /// leaves updated. Tested before the first iteration too. On a singular grid the mean of r is removed.
  /// Collective. Throws SolverError when `max_iterations` do not suffice or a number is not finite.
  KrylovReport solve(CellField<double>& r, CellField<double>& p, double tolerance_rms, int max_iterations);

 private:
  const PressureGrid& grid_;
  Preconditioner& preconditioner_;
  // The direction in single precision: A is applied to exactly what is added to p, so nothing is lost but traffic.
  CellField<float> direction_, z_;
  CellField<double> a_direction_;
};

}  // namespace valsalva::ib3d
