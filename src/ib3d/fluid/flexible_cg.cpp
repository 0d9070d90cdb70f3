#include "ib3d/fluid/flexible_cg.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "common/error.hpp"
#include "ib3d/fluid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

template <class Row>
void for_each_local_row(const Level& level, Row&& row)
{
  for (int p = 0; p < level.local_count(); ++p) {
    const IndexBox& box = level.local_box(p);
    for_each_row(box, [&](int j, int k) { row(p, box.lo[0], j, k, box.size(0)); });
  }
}

template <std::size_t N>
std::array<double, N> sum_over_ranks(const Level& level, std::array<double, N> local)
{
  MPI_Allreduce(MPI_IN_PLACE, local.data(), static_cast<int>(N), MPI_DOUBLE, MPI_SUM, level.comm);
  return local;
}

void remove_mean(const Level& level, CellField<double>& r)
{
  double sum = 0;
  for_each_local_row(level, [&](int p, int i0, int j, int k, int n) {
    const double* x = r[p].at(i0, j, k);
    for (int i = 0; i < n; ++i) sum += x[i];
  });
  const double mean = sum_over_ranks<1>(level, {sum})[0] / static_cast<double>(level.cell_count());
  for_each_local_row(level, [&](int p, int i0, int j, int k, int n) {
    double* x = r[p].at(i0, j, k);
    for (int i = 0; i < n; ++i) x[i] -= mean;
  });
}

double largest(const Level& level, const CellField<double>& r)
{
  double m = 0;
  for_each_local_row(level, [&](int p, int i0, int j, int k, int n) {
    const double* x = r[p].at(i0, j, k);
    for (int i = 0; i < n; ++i) m = std::max(m, std::abs(x[i]));
  });
  MPI_Allreduce(MPI_IN_PLACE, &m, 1, MPI_DOUBLE, MPI_MAX, level.comm);
  return m;
}

}  // namespace

FlexibleCg::FlexibleCg(const PressureGrid& grid, Preconditioner& preconditioner)
    : grid_(grid),
      preconditioner_(preconditioner),
      direction_(grid.level()),
      z_(grid.level()),
      a_direction_(grid.level())
{
}

KrylovReport FlexibleCg::solve(CellField<double>& r, CellField<double>& p, double tolerance_rms,
                               int max_iterations)
{
  const Level& level = grid_.level();
  const double cells = static_cast<double>(level.cell_count());
  const double h2 = level.h * level.h;
  if (grid_.singular()) remove_mean(level, r);

  KrylovReport report;
  double rms = std::sqrt(dot(level, r, r) / cells);
  report.initial_rms = rms;
  double beta = 0, z_r_old = 0, alpha = 0;
  while (rms > tolerance_rms) {
    if (report.iterations == max_iterations)
      throw SolverError(
          fmt::format("the pressure solve has not converged after {} iterations (residual {:.3g}, from "
                      "{:.3g}, wanted {:.3g})",
                      max_iterations, rms, report.initial_rms, tolerance_rms));
    preconditioner_.apply(r, 1 / rms, z_);
    const double unscale = rms * h2;

    std::array<double, 2> products{};  // <z, r>, <z, A d_old>
    for_each_local_row(level, [&](int q, int i, int j, int k, int n) {
      const TwoSums s = two_products_row(z_[q].at(i, j, k), r[q].at(i, j, k), a_direction_[q].at(i, j, k), n);
      products[0] += s.first;
      products[1] += s.second;
    });
    products = sum_over_ranks<2>(level, products);
    const double z_r = unscale * products[0];
    beta =
        report.iterations == 0 ? 0 : -alpha * unscale * products[1] / z_r_old;  // r - r_old = -alpha A d_old
    z_r_old = z_r;

    for_each_local_row(level, [&](int q, int i, int j, int k, int n) {
      direction_row(direction_[q].at(i, j, k), z_[q].at(i, j, k), unscale, beta, n);
    });
    grid_.fill_ghosts(direction_);

    std::array<double, 2> curvature{};  // <d, A d>, <d, r>
    for_each_local_row(level, [&](int q, int i, int j, int k, int n) {
      const TwoSums s = apply_row(a_direction_[q].at(i, j, k), direction_[q].at(i, j, k), r[q].at(i, j, k),
                                  1 / h2, direction_[q].stride(1), direction_[q].stride(2), n);
      curvature[0] += s.first;
      curvature[1] += s.second;
    });
    curvature = sum_over_ranks<2>(level, curvature);
    alpha = curvature[1] / curvature[0];

    double square = 0;
    for_each_local_row(level, [&](int q, int i, int j, int k, int n) {
      square += update_row(p[q].at(i, j, k), r[q].at(i, j, k), direction_[q].at(i, j, k),
                           a_direction_[q].at(i, j, k), alpha, n);
    });
    rms = std::sqrt(sum_over_ranks<1>(level, {square})[0] / cells);
    ++report.iterations;
    if (!std::isfinite(rms)) throw SolverError("the pressure solve met a number that is not finite");
  }
  if (!std::isfinite(rms)) throw SolverError("the pressure solve was given a number that is not finite");
  report.final_rms = rms;
  report.final_max = largest(level, r);
  return report;
}

}  // namespace valsalva::ib3d
