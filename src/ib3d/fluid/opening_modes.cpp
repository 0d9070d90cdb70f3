#include "ib3d/fluid/opening_modes.hpp"

#include <cmath>

namespace valsalva::ib3d {

namespace {

/// p_b = 1 on the disc of `opening`, 0 elsewhere.
BoundaryPressure indicator(const PressureGrid& grid, const Opening& opening)
{
  BoundaryPressure p_b = grid.zero_boundary_pressure();
  for (auto& patch : p_b)
    for (SidePlane<double>& plane : patch)
      if (plane.side == opening.side)
        for (int b = plane.lo2; b < plane.lo2 + plane.n2; ++b)
          for (int a = plane.lo1; a < plane.lo1 + plane.n1; ++a)
            if (in_disc(opening, grid.level(), a, b)) plane(a, b) = 1.0;
  return p_b;
}

/// The gradient of p on the faces normal to z, where openings are; the other components stay zero.
void z_gradient(const Level& level, const CellField<double>& p, MacField& gradient)
{
  for (int q = 0; q < level.local_count(); ++q)
    for_each_index(faces_of(level.local_box(q), 2), [&](int i, int j, int k) {
      gradient(q, 2)(i, j, k) = (p[q](i, j, k) - p[q](i, j, k - 1)) / level.h;
    });
}

/// p += a x + b y.
inline void add_two_rows(double* __restrict p, const double* x, double a, const double* y, double b,
                         std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i) p[i] += a * x[i] + b * y[i];
}

}  // namespace

OpeningModes::OpeningModes(const Level& level, const std::vector<Opening>& openings, PressureSolver& solver,
                           double density)
    : conductance_(openings.size(), openings.size())
{
  const PressureGrid& grid = solver.grid();
  CellField<double> r(level);
  MacField gradient(level, 1);
  for (std::size_t k = 0; k < openings.size(); ++k) {
    const BoundaryPressure p_b = indicator(grid, openings[k]);
    CellField<double>& psi = psi_.emplace_back(level);
    grid.fill_ghosts(psi, p_b);  // psi = 0 inside: the residual lap psi is the boundary data alone
    for (int q = 0; q < level.local_count(); ++q) {
      const std::ptrdiff_t sy = psi[q].stride(1), sz = psi[q].stride(2);
      for_each_index(level.local_box(q), [&](int i, int j, int l) {
        const double* c = psi[q].at(i, j, l);
        r[q](i, j, l) = (c[-1] + c[1] + c[-sy] + c[sy] + c[-sz] + c[sz] - 6 * c[0]) / (level.h * level.h);
      });
    }
    const double rms = std::sqrt(dot(level, r, r) / static_cast<double>(level.cell_count()));
    solver.solve(r, psi, 1e-11 * rms);
    grid.fill_ghosts(psi, p_b);
    z_gradient(level, psi, gradient);
    const std::vector<double> flux = flow_through(openings, level, gradient);
    for (std::size_t j = 0; j < openings.size(); ++j)
      conductance_(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = flux[j] / density;
  }
}

void OpeningModes::add(const std::vector<double>& phi, CellField<double>& p) const
{
  std::size_t k = 0;
  for (; k + 1 < phi.size(); k += 2)  // two at a time: the pass is bound by memory
    for (int q = 0; q < p.patch_count(); ++q)
      add_two_rows(p[q].data().data(), psi_[k][q].data().data(), phi[k], psi_[k + 1][q].data().data(),
                   phi[k + 1], p[q].data().size());
  for (; k < phi.size(); ++k)
    for (int q = 0; q < p.patch_count(); ++q)
      add_two_rows(p[q].data().data(), psi_[k][q].data().data(), phi[k], psi_[k][q].data().data(), 0.0,
                   p[q].data().size());
}

}  // namespace valsalva::ib3d
