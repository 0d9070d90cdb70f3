// The pressure problem with its solver, chosen by name: "multilevel" (our V-cycle over all levels with hypre at the
// base) or, on one level, "pfmg" (hypre's PFMG, one cycle per iteration), both inside flexible CG.
#pragma once

#include <memory>
#include <string>

#include "ib3d/fluid/pressure/flexible_cg.hpp"

namespace valsalva::ib3d {

/// Keys of [pressure].
struct PressureOptions {
  std::string solver = "multilevel";
  double divergence_tolerance = 5e-3;  ///< 1/s, rms of the remaining div u
  int max_iterations = 60;
};

class PressureSolver {
 public:
  /// std::invalid_argument for an unknown name, or "pfmg" with refined levels. `grid` and
  /// `transfers` must outlive the object. Collective.
  PressureSolver(const Hierarchy& grid, const std::vector<Opening>& openings, const PressureOptions& options,
                 std::vector<CoarseFine>& transfers);
  CompositePressure& problem() { return problem_; }
  const CompositePressure& problem() const { return problem_; }
  /// Improves p until rms(lap p - source div u) <= tolerance_rms on the valid cells, with the boundary pressures p_b;
  /// u may be null. Leaves the ghosts of p filled. Collective.
  KrylovReport solve(CompositeCells<double>& p, const std::vector<BoundaryPressure>& p_b,
                     const CompositeMac* u, double source, double tolerance_rms, int max_iterations);
  const PressureOptions& options() const { return options_; }

 private:
  PressureOptions options_;
  CompositePressure problem_;
  std::unique_ptr<Preconditioner> preconditioner_;
  std::unique_ptr<FlexibleCg> krylov_;
};

}  // namespace valsalva::ib3d
