#include "ib3d/fluid/pressure/pressure_solver.hpp"

#include <stdexcept>

#include "ib3d/fluid/pressure/multilevel.hpp"

namespace valsalva::ib3d {

PressureSolver::PressureSolver(const Hierarchy& grid, const std::vector<Opening>& openings,
                               const PressureOptions& options, std::vector<CoarseFine>& transfers)
    : options_(options), problem_(grid, openings, transfers)
{
  if (options.solver == "multilevel")
    preconditioner_ = std::make_unique<Multilevel>(problem_);
  else if (options.solver == "pfmg" && grid.level_count() == 1)
    preconditioner_ = std::make_unique<HyprePfmg>(problem_.grid(0), 1);
  else
    throw std::invalid_argument("no pressure solver \"" + options.solver + "\" for this number of levels");
  krylov_ = std::make_unique<FlexibleCg>(problem_, *preconditioner_);
}

KrylovReport PressureSolver::solve(CompositeCells<double>& p, const std::vector<BoundaryPressure>& p_b,
                                   const CompositeMac* u, double source, double tolerance_rms,
                                   int max_iterations)
{
  const KrylovReport report = krylov_->solve(
      p, [&](CompositeCells<float>& r) { problem_.residual(p, p_b, u, source, r); }, tolerance_rms,
      max_iterations);
  problem_.fill_ghosts(p, p_b);
  return report;
}

}  // namespace valsalva::ib3d
