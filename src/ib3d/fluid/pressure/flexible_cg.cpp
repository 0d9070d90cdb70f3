#include "ib3d/fluid/pressure/flexible_cg.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "common/error.hpp"
#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

/// Reduction of the residual that single precision carries safely.
constexpr double kTrustedReduction = 1e-4;

}  // namespace

FlexibleCg::FlexibleCg(CompositePressure& problem, Preconditioner& preconditioner)
    : problem_(problem),
      preconditioner_(preconditioner),
      grid_(problem.hierarchy()),
      r_(composite_cells<float>(grid_)),
      direction_(composite_cells<float>(grid_)),
      z_(composite_cells<float>(grid_)),
      a_direction_(composite_cells<float>(grid_))
{
  const Level& coarsest = grid_.level(0);
  volume_ = static_cast<double>(coarsest.box.volume()) * std::pow(coarsest.h, 3);
}

double FlexibleCg::sum_over_ranks(double local) const
{
  MPI_Allreduce(MPI_IN_PLACE, &local, 1, MPI_DOUBLE, MPI_SUM, grid_.comm());
  return local;
}

double FlexibleCg::rms() const
{
  double sum = 0;
  for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    const float* r = r_[l][q].at(i, j, k);
    sum += two_products_row(r, r, r, n).first / grid_.levels()[l].h;
  });
  return std::sqrt(sum_over_ranks(sum) / volume_);
}

double FlexibleCg::largest() const
{
  double m = 0;
  for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    const double h = grid_.levels()[l].h;
    m = std::max(m, static_cast<double>(largest_in_row(r_[l][q].at(i, j, k), n)) / (h * h));
  });
  MPI_Allreduce(MPI_IN_PLACE, &m, 1, MPI_DOUBLE, MPI_MAX, grid_.comm());
  return m;
}

void FlexibleCg::remove_mean()
{
  double sum = 0;
  for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    const float* r = r_[l][q].at(i, j, k);
    double row = 0;
    for (int m = 0; m < n; ++m) row += static_cast<double>(r[m]);
    sum += grid_.levels()[l].h * row;
  });
  const double mean = sum_over_ranks(sum) / volume_;
  for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    const double h = grid_.levels()[l].h;
    float* r = r_[l][q].at(i, j, k);
    for (int m = 0; m < n; ++m) r[m] -= static_cast<float>(mean * h * h);
  });
  for (int l = 0; l < grid_.level_count(); ++l) problem_.zero_covered(l, r_[static_cast<std::size_t>(l)]);
}

KrylovReport FlexibleCg::solve(CompositeCells<double>& p,
                               const std::function<void(CompositeCells<float>&)>& residual,
                               double tolerance_rms, int max_iterations)
{
  KrylovReport report;
  for (bool first = true;; first = false) {
    residual(r_);
    if (problem_.singular()) remove_mean();
    const double now = rms();
    if (!std::isfinite(now)) throw SolverError("the pressure solve was given a number that is not finite");
    if (first) report.initial_rms = now;
    report.final_rms = now;
    if (now <= tolerance_rms) break;
    const double target = std::max(tolerance_rms, kTrustedReduction * now);
    report.final_rms = iterate(p, now, target, max_iterations, report);
    if (report.final_rms <= tolerance_rms) break;
  }
  report.final_max = largest();
  return report;
}

double FlexibleCg::iterate(CompositeCells<double>& p, double rms, double target, int max_iterations,
                           KrylovReport& report)
{
  double z_r_old = 0, alpha = 0;
  for (bool first = true; rms > target; first = false) {
    if (report.iterations == max_iterations)
      throw SolverError(
          fmt::format("the pressure solve has not converged after {} iterations (residual {:.3g}, from "
                      "{:.3g}, wanted {:.3g})",
                      max_iterations, rms, report.initial_rms, target));
    preconditioner_.apply(r_, z_);

    std::array<double, 2> products{};  // <z, r>, <z, A d_old>
    for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
      const TwoSums s =
          two_products_row(z_[l][q].at(i, j, k), r_[l][q].at(i, j, k), a_direction_[l][q].at(i, j, k), n);
      products[0] += grid_.levels()[l].h * s.first;
      products[1] += grid_.levels()[l].h * s.second;
    });
    MPI_Allreduce(MPI_IN_PLACE, products.data(), 2, MPI_DOUBLE, MPI_SUM, grid_.comm());
    const double beta = first ? 0 : -alpha * products[1] / z_r_old;  // r - r_old = -alpha A d_old
    z_r_old = products[0];
    for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
      direction_row(direction_[l][q].at(i, j, k), z_[l][q].at(i, j, k), static_cast<float>(beta), n);
    });

    std::array<double, 2> curvature = problem_.apply(direction_, r_, a_direction_);  // <d, A d>, <d, r>
    MPI_Allreduce(MPI_IN_PLACE, curvature.data(), 2, MPI_DOUBLE, MPI_SUM, grid_.comm());
    alpha = curvature[1] / curvature[0];

    double square = 0;
    for_each_local_row(grid_, [&](std::size_t l, int q, int i, int j, int k, int n) {
      square += update_row(p[l][q].at(i, j, k), r_[l][q].at(i, j, k), direction_[l][q].at(i, j, k),
                           a_direction_[l][q].at(i, j, k), static_cast<float>(alpha), n) /
                grid_.levels()[l].h;
    });
    rms = std::sqrt(sum_over_ranks(square) / volume_);
    ++report.iterations;
    if (!std::isfinite(rms)) throw SolverError("the pressure solve met a number that is not finite");
  }
  return rms;
}

}  // namespace valsalva::ib3d
