// The pressure problem of one grid with its solver, chosen by name: "multilevel" (our V-cycle with hypre at
// the base) or "pfmg" (hypre's PFMG, one cycle per iteration), both inside flexible CG.
#pragma once

#include <memory>
#include <string>

#include "ib3d/fluid/flexible_cg.hpp"

namespace valsalva::ib3d {

struct PressureOptions {
  std::string solver = "multilevel";
  double divergence_tolerance = 1e-3;  ///< 1/s, rms of what is left of div u
  int max_iterations = 60;
};

class PressureSolver {
 public:
  /// Collective. Throws CaseError("pressure.solver") for an unknown name.
  PressureSolver(const Level& level, const std::vector<Opening>& openings, const PressureOptions& options);
  const PressureGrid& grid() const { return *grid_; }
  /// Improves p until rms(r) <= tolerance_rms; r enters and leaves as the residual (see FlexibleCg).
  /// Collective.
  KrylovReport solve(CellField<double>& r, CellField<double>& p, double tolerance_rms);
  const PressureOptions& options() const { return options_; }

 private:
  PressureOptions options_;
  std::unique_ptr<PressureGrid> grid_;
  std::unique_ptr<Preconditioner> preconditioner_;
  std::unique_ptr<FlexibleCg> krylov_;
};

}  // namespace valsalva::ib3d
