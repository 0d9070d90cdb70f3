#include "ib3d/fluid/opening_modes.hpp"

#include <cmath>

#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

constexpr int kIterations = 200;  // to ten digits from nothing; a step needs about three

/// p_b = 1 on the disc of an opening, 0 elsewhere.
std::vector<BoundaryPressure> indicator(const CompositePressure& problem,
                                        const std::vector<OpeningFaces::Face>& disc)
{
  std::vector<BoundaryPressure> p_b = problem.zero_boundary_pressure();
  for (const OpeningFaces::Face& f : disc) set_boundary_pressure(p_b, f, 1.0);
  return p_b;
}

}  // namespace

OpeningModes::OpeningModes(const OpeningFaces& openings, PressureSolver& solver, double density)
    : conductance_(openings.count(), openings.count())
{
  const Hierarchy& grid = solver.problem().hierarchy();
  for (int k = 0; k < openings.count(); ++k) {
    const std::vector<BoundaryPressure> p_b =
        indicator(solver.problem(), openings.of(static_cast<std::size_t>(k)));
    CompositeCells<double>& psi = psi_.emplace_back(composite_cells<double>(grid));
    const double largest_gradient = 1 / std::pow(grid.finest().h, 2);
    solver.solve(psi, p_b, nullptr, 0, 1e-10 * largest_gradient, kIterations);
    const std::vector<double> flux =
        openings.flow_of([&](const OpeningFaces::Face& f) { return f.jump(psi) / grid.level(f.level).h; });
    for (int j = 0; j < openings.count(); ++j)
      conductance_(j, k) = flux[static_cast<std::size_t>(j)] / density;
  }
}

void OpeningModes::add_to_plane(const std::vector<double>& phi, int level, int patch, int k,
                                Array3<double>& p) const
{
  const IndexBox& box = p.stored();
  for (std::size_t m = 0; m < phi.size(); ++m)
    add_row(p.at(box.lo[0], box.lo[1], k),
            psi_[m][static_cast<std::size_t>(level)][patch].at(box.lo[0], box.lo[1], k), phi[m],
            static_cast<int>(p.stride(2)));
}

}  // namespace valsalva::ib3d
