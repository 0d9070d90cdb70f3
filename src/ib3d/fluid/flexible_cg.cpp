#include "ib3d/fluid/flexible_cg.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "common/error.hpp"

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
      a_direction_(grid.level()),
      scaled_(grid.level()),
      z_(grid.level())
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
    // z = M^{-1} r, on the residual scaled to 1
    const double scale = 1 / rms;
    for_each_local_row(level, [&](int q, int i0, int j, int k, int n) {
      const double* from = r[q].at(i0, j, k);
      double* to = scaled_[q].at(i0, j, k);
      for (int i = 0; i < n; ++i) to[i] = scale * from[i];
    });
    preconditioner_.apply(scaled_, z_);
    const double unscale = rms * h2;

    std::array<double, 2> products{};  // <z, r>, <z, A d_old>
    for_each_local_row(level, [&](int q, int i0, int j, int k, int n) {
      const float* z = z_[q].at(i0, j, k);
      const double* res = r[q].at(i0, j, k);
      const double* ad = a_direction_[q].at(i0, j, k);
      double zr = 0, zad = 0;
#pragma omp simd reduction(+ : zr, zad)
      for (int i = 0; i < n; ++i) {
        zr += z[i] * res[i];
        zad += z[i] * ad[i];
      }
      products[0] += zr;
      products[1] += zad;
    });
    products = sum_over_ranks<2>(level, products);
    const double z_r = unscale * products[0];
    beta =
        report.iterations == 0 ? 0 : -alpha * unscale * products[1] / z_r_old;  // r - r_old = -alpha A d_old
    z_r_old = z_r;

    for_each_local_row(level, [&](int q, int i0, int j, int k, int n) {
      const float* z = z_[q].at(i0, j, k);
      double* d = direction_[q].at(i0, j, k);
      if (report.iterations == 0)
        for (int i = 0; i < n; ++i) d[i] = unscale * z[i];
      else
        for (int i = 0; i < n; ++i) d[i] = unscale * z[i] + beta * d[i];
    });
    grid_.fill_ghosts(direction_);

    std::array<double, 2> curvature{};  // <d, A d>, <d, r>
    for_each_local_row(level, [&](int q, int i0, int j, int k, int n) {
      const double* __restrict d = direction_[q].at(i0, j, k);
      const double* __restrict res = r[q].at(i0, j, k);
      double* __restrict ad = a_direction_[q].at(i0, j, k);
      const std::ptrdiff_t sy = direction_[q].stride(1), sz = direction_[q].stride(2);
      double dad = 0, dr = 0;
#pragma omp simd reduction(+ : dad, dr)
      for (int i = 0; i < n; ++i) {
        const double neighbours = (d[i - 1] + d[i + 1]) + (d[i - sy] + d[i + sy]) + (d[i - sz] + d[i + sz]);
        const double y = (6 * d[i] - neighbours) / h2;
        ad[i] = y;
        dad += d[i] * y;
        dr += d[i] * res[i];
      }
      curvature[0] += dad;
      curvature[1] += dr;
    });
    curvature = sum_over_ranks<2>(level, curvature);
    alpha = curvature[1] / curvature[0];

    double square = 0;
    for_each_local_row(level, [&](int q, int i0, int j, int k, int n) {
      const double* __restrict d = direction_[q].at(i0, j, k);
      const double* __restrict ad = a_direction_[q].at(i0, j, k);
      double* __restrict x = p[q].at(i0, j, k);
      double* __restrict res = r[q].at(i0, j, k);
      double row = 0;
#pragma omp simd reduction(+ : row)
      for (int i = 0; i < n; ++i) {
        x[i] += alpha * d[i];
        res[i] -= alpha * ad[i];
        row += res[i] * res[i];
      }
      square += row;
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
