#include "ib3d/fluid/pressure/composite_pressure.hpp"

#include <algorithm>

#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

std::vector<CoarseFine> transfers_between_levels(const Hierarchy& grid, int ghosts)
{
  std::vector<CoarseFine> transfers;
  for (int l = 1; l < grid.level_count(); ++l)
    transfers.emplace_back(grid.level(l - 1), grid.level(l), ghosts);
  return transfers;
}

CompositePressure::CompositePressure(const Hierarchy& grid, const std::vector<Opening>& openings,
                                     std::vector<CoarseFine>& transfers)
    : hierarchy_(grid), transfers_(transfers)
{
  for (int l = 0; l < grid.level_count(); ++l) {
    grids_.emplace_back(grid, l, openings);
    if (l > 0) edges_.emplace_back(grid.level(l - 1), grid.level(l));
  }
}

std::vector<BoundaryPressure> CompositePressure::zero_boundary_pressure() const
{
  std::vector<BoundaryPressure> zero;
  for (const PressureGrid& g : grids_) zero.push_back(g.zero_boundary_pressure());
  return zero;
}

template <class T>
void CompositePressure::fill(CompositeCells<T>& p, const std::vector<BoundaryPressure>* p_b)
{
  for (std::size_t l = grids_.size() - 1; l > 0; --l) transfers_[l - 1].average_down(p[l], p[l - 1]);
  for (std::size_t l = 0; l < grids_.size(); ++l) {
    grids_[l].fill_ghosts(p[l]);
    if constexpr (std::is_same_v<T, double>)
      if (p_b != nullptr) grids_[l].add_prescribed(p[l], (*p_b)[l]);
    if (l == 0) continue;
    edges_[l - 1].take_base(p[l - 1]);
    edges_[l - 1].fill_ghosts(p[l]);
  }
}

template void CompositePressure::fill(CompositeCells<float>&, const std::vector<BoundaryPressure>*);
template void CompositePressure::fill(CompositeCells<double>&, const std::vector<BoundaryPressure>*);

template <class T>
void CompositePressure::correct_edge(int l, const CompositeCells<T>& p, CellField<float>& y, float sign)
{
  const auto ll = static_cast<std::size_t>(l);
  edges_[ll].for_each_flux(p[ll + 1], [&](int patch, const Int3& c, Side side, double jumps) {
    const Array3<T>& a = p[ll][patch];
    const std::ptrdiff_t to_covered = inward(side) * a.stride(axis(side));
    const T* x = a.at(c[0], c[1], c[2]);
    // h_c^2 (mean of the four fine gradients)/h_c = (sum of jumps)/4 h_c/h_f.
    y[patch](c[0], c[1], c[2]) += sign * static_cast<float>(0.5 * jumps + static_cast<double>(x[to_covered]) -
                                                            static_cast<double>(x[0]));
  });
}

void CompositePressure::residual(CompositeCells<double>& p, const std::vector<BoundaryPressure>& p_b,
                                 const CompositeMac* u, double source, CompositeCells<float>& r)
{
  fill(p, &p_b);
  for_each_local_row(hierarchy_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    const std::ptrdiff_t sy = p[l][q].stride(1), sz = p[l][q].stride(2);
    if (u == nullptr) {
      laplacian_row(r[l][q].at(i, j, k), p[l][q].at(i, j, k), sy, sz, n);
      return;
    }
    const MacField& v = (*u)[l];
    pressure_residual_row(r[l][q].at(i, j, k), p[l][q].at(i, j, k), v(q, 0).at(i, j, k), v(q, 1).at(i, j, k),
                          v(q, 2).at(i, j, k), source * grids_[l].level().h, sy, sz, v(q, 1).stride(1),
                          v(q, 2).stride(2), n);
  });
  for (int l = hierarchy_.level_count() - 2; l >= 0; --l) {
    correct_edge(l, p, r[static_cast<std::size_t>(l)], -1.0f);
    zero_covered(l, r[static_cast<std::size_t>(l)]);
  }
}

std::array<double, 2> CompositePressure::apply(CompositeCells<float>& d, const CompositeCells<float>& r,
                                               CompositeCells<float>& y)
{
  fill(d, nullptr);
  std::vector<TwoSums> sums(grids_.size());
  for_each_local_row(hierarchy_, [&](std::size_t l, int q, int i, int j, int k, int n) {
    sums[l] += apply_row(y[l][q].at(i, j, k), d[l][q].at(i, j, k), r[l][q].at(i, j, k), d[l][q].stride(1),
                         d[l][q].stride(2), n);
  });
  for (int l = hierarchy_.level_count() - 2; l >= 0; --l) {
    const auto ll = static_cast<std::size_t>(l);
    correct_edge(l, d, y[ll], 1.0f);
    zero_covered(l, y[ll]);
    sums[ll] = {};
    const Level& level = hierarchy_.level(l);
    for (int q = 0; q < level.local_count(); ++q) {
      const IndexBox& box = level.local_box(q);
      for_each_row(box, [&](int j, int k) {
        const int i = box.lo[0];
        sums[ll] +=
            two_products_row(d[ll][q].at(i, j, k), y[ll][q].at(i, j, k), r[ll][q].at(i, j, k), box.size(0));
      });
    }
  }
  std::array<double, 2> total{};
  for (std::size_t l = 0; l < sums.size(); ++l) {
    total[0] += grids_[l].level().h * sums[l].first;
    total[1] += grids_[l].level().h * sums[l].second;
  }
  return total;
}

template <class T>
void CompositePressure::zero_covered(int l, CellField<T>& a) const
{
  if (l + 1 >= hierarchy_.level_count()) return;
  const auto& covered = transfers_[static_cast<std::size_t>(l)].covered();
  for (int p = 0; p < a.patch_count(); ++p)
    for (const IndexBox& box : covered[static_cast<std::size_t>(p)])
      for_each_row(box, [&](int j, int k) { std::fill_n(a[p].at(box.lo[0], j, k), box.size(0), T{}); });
}
template void CompositePressure::zero_covered(int, CellField<float>&) const;

}  // namespace valsalva::ib3d
