#include "ib3d/fluid/pressure_grid.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

bool no_pressure_anywhere(const Level& level, const std::vector<std::vector<SidePlane<float>>>& shares)
{
  int prescribed = 0;
  for (const auto& patch : shares)
    for (const auto& plane : patch)
      for (float theta : plane.value) prescribed = prescribed != 0 || theta > 0 ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &prescribed, 1, MPI_INT, MPI_MAX, level.comm);
  return prescribed == 0;
}

/// ghost = (1 - 2 theta) p1 + 2 theta p_b along one side, corner ghosts included; p_b may be null (zero).
template <class T>
void fill_side(const Level& level, const SidePlane<float>& theta, const SidePlane<double>* p_b, Array3<T>& p)
{
  const int d = side_direction(theta.side);
  const auto dd = static_cast<std::size_t>(d);
  const bool high = side_is_high(theta.side);
  const int ghost = high ? level.box.hi[dd] : level.box.lo[dd] - 1;
  const std::ptrdiff_t inward = (high ? -1 : 1) * p.stride(d);
  for (int b = theta.lo2 - 1; b <= theta.lo2 + theta.n2; ++b)
    for (int a = theta.lo1 - 1; a <= theta.lo1 + theta.n1; ++a) {
      Int3 at{};
      at[dd] = ghost;
      at[static_cast<std::size_t>(theta.t1)] = a;
      at[static_cast<std::size_t>(theta.t2)] = b;
      T* g = p.at(at[0], at[1], at[2]);
      const T share = static_cast<T>(theta.clamped(a, b));
      *g = (1 - 2 * share) * g[inward];
      if (p_b != nullptr) *g += 2 * share * static_cast<T>(p_b->clamped(a, b));
    }
}

}  // namespace

PressureGrid::PressureGrid(const Level& level, const std::vector<Opening>& openings) : level_(level)
{
  for (int p = 0; p < level.local_count(); ++p) shares_.push_back(pressure_shares(level, p, openings));
  singular_ = no_pressure_anywhere(level_, shares_);
  halo_.push_back(Halo::for_cells(level_, 1));
}

PressureGrid PressureGrid::coarsened() const
{
  PressureGrid coarse;
  coarse.level_ = level_.coarsened();
  coarse.singular_ = singular_;
  coarse.halo_.push_back(Halo::for_cells(coarse.level_, 1));
  for (int p = 0; p < level_.local_count(); ++p) {
    coarse.shares_.emplace_back();
    for (const SidePlane<float>& fine : shares(p)) {
      SidePlane<float> plane(coarse.level_.local_box(p), fine.side, 0.0f);
      for (int b = plane.lo2; b < plane.lo2 + plane.n2; ++b)
        for (int a = plane.lo1; a < plane.lo1 + plane.n1; ++a) {
          const float mean = 0.25f * (fine(2 * a, 2 * b) + fine(2 * a + 1, 2 * b) + fine(2 * a, 2 * b + 1) +
                                      fine(2 * a + 1, 2 * b + 1));
          plane(a, b) = std::min(1.0f, 1.25f * mean);
        }
      coarse.shares_.back().push_back(std::move(plane));
    }
  }
  return coarse;
}

BoundaryPressure PressureGrid::zero_boundary_pressure() const
{
  BoundaryPressure zero;
  for (int p = 0; p < level_.local_count(); ++p) {
    zero.emplace_back();
    for (const SidePlane<float>& theta : shares(p))
      zero.back().emplace_back(level_.local_box(p), theta.side, 0.0);
  }
  return zero;
}

template <class T>
void PressureGrid::fill_ghosts(CellField<T>& p) const
{
  halo_[0].fill(p);
  for (int patch = 0; patch < p.patch_count(); ++patch)
    for (const SidePlane<float>& theta : shares(patch)) fill_side(level_, theta, nullptr, p[patch]);
}
template void PressureGrid::fill_ghosts(CellField<double>&) const;
template void PressureGrid::fill_ghosts(CellField<float>&) const;

void PressureGrid::fill_ghosts(CellField<double>& p, const BoundaryPressure& p_b) const
{
  halo_[0].fill(p);
  for (int patch = 0; patch < p.patch_count(); ++patch)
    for (std::size_t s = 0; s < shares(patch).size(); ++s)
      fill_side(level_, shares(patch)[s], &p_b[static_cast<std::size_t>(patch)][s], p[patch]);
}

double dot(const Level& level, const CellField<double>& a, const CellField<double>& b)
{
  double sum = 0;
  for (int p = 0; p < level.local_count(); ++p) {
    const IndexBox& box = level.local_box(p);
    for_each_row(box, [&](int j, int k) {
      const double* x = a[p].at(box.lo[0], j, k);
      const double* y = b[p].at(box.lo[0], j, k);
      double row = 0;
#pragma omp simd reduction(+ : row)
      for (int i = 0; i < box.size(0); ++i) row += x[i] * y[i];
      sum += row;
    });
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, level.comm);
  return sum;
}

}  // namespace valsalva::ib3d
