#include "ib3d/fluid/pressure_solver.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "ib3d/fluid/multilevel.hpp"

namespace valsalva::ib3d {

PressureSolver::PressureSolver(const Level& level, const std::vector<Opening>& openings,
                               const PressureOptions& options)
    : options_(options), grid_(std::make_unique<PressureGrid>(level, openings))
{
  if (options.solver == "multilevel")
    preconditioner_ = std::make_unique<Multilevel>(*grid_);
  else if (options.solver == "pfmg")
    preconditioner_ = std::make_unique<HyprePfmg>(*grid_, 1);
  else
    throw CaseError("pressure.solver",
                    fmt::format("is \"{}\"; known solvers are \"multilevel\" and \"pfmg\"", options.solver));
  krylov_ = std::make_unique<FlexibleCg>(*grid_, *preconditioner_);
}

KrylovReport PressureSolver::solve(CellField<double>& r, CellField<double>& p, double tolerance_rms)
{
  return krylov_->solve(r, p, tolerance_rms, options_.max_iterations);
}

}  // namespace valsalva::ib3d
