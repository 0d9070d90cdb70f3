#include "ib3d/fluid/multilevel.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

constexpr float kOverRelaxation = 1.15f;
constexpr int kLongestRow = 4096;

/// 1, 0, 1, 0, ...: the rows of one colour of the checkerboard.
const float* colour_mask(bool first_is_set)
{
  static const std::vector<float> mask = [] {
    std::vector<float> m(kLongestRow + 1);
    for (std::size_t i = 0; i < m.size(); i += 2) m[i] = 1.0f;
    return m;
  }();
  return mask.data() + (first_is_set ? 0 : 1);
}

/// t = rhs - A e along a row of n cells; sy, sz the strides of e.
inline void residual_row(float* __restrict t, const float* __restrict rhs, const float* __restrict e,
                         std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  for (int i = 0; i < n; ++i)
    t[i] = rhs[i] - 6 * e[i] + ((e[i - 1] + e[i + 1]) + (e[i - sy] + e[i + sy]) + (e[i - sz] + e[i + sz]));
}

/// rhs of the coarser level = h_c^2 x mean of the residual over the eight fine cells (h^2 scaling: 4 x mean).
void restrict_residual(const Level& coarse, const CellField<float>& rhs, const CellField<float>& e,
                       CellField<float>& coarse_rhs)
{
  std::vector<float> sum, t;
  for (int p = 0; p < coarse.local_count(); ++p) {
    const IndexBox& box = coarse.local_box(p);
    const int n = 2 * box.size(0);
    sum.resize(static_cast<std::size_t>(n));
    t.resize(static_cast<std::size_t>(n));
    for_each_row(box, [&](int j, int k) {
      std::fill(sum.begin(), sum.end(), 0.0f);
      for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) {
          const float* row = e[p].at(2 * box.lo[0], 2 * j + a, 2 * k + b);
          residual_row(t.data(), rhs[p].at(2 * box.lo[0], 2 * j + a, 2 * k + b), row, e[p].stride(1),
                       e[p].stride(2), n);
          for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += t[i];
        }
      float* out = coarse_rhs[p].at(box.lo[0], j, k);
      for (int i = 0; i < box.size(0); ++i)
        out[i] = 0.5f * (sum[static_cast<std::size_t>(2 * i)] + sum[static_cast<std::size_t>(2 * i + 1)]);
    });
  }
}

/// e += trilinear prolongation of the coarse correction, whose ghosts must be filled.
void add_prolongation(const Level& fine, const CellField<float>& coarse, CellField<float>& e)
{
  std::vector<float> mixed;
  for (int p = 0; p < fine.local_count(); ++p) {
    const IndexBox& box = fine.local_box(p);
    const int n = box.size(0) / 2;
    mixed.resize(static_cast<std::size_t>(n) + 2);
    const std::ptrdiff_t sy = coarse[p].stride(1), sz = coarse[p].stride(2);
    for_each_row(box, [&](int j, int k) {
      // The two coarse rows (planes) around a fine row: its own with 3/4, the nearer neighbour with 1/4.
      const std::ptrdiff_t to_y = (j & 1) != 0 ? sy : -sy, to_z = (k & 1) != 0 ? sz : -sz;
      const float* c = coarse[p].at(box.lo[0] / 2 - 1, j >> 1, k >> 1);
      float* __restrict m = mixed.data();
      for (int i = 0; i < n + 2; ++i)
        m[i] = 0.5625f * c[i] + 0.1875f * (c[i + to_y] + c[i + to_z]) + 0.0625f * c[i + to_y + to_z];
      float* __restrict out = e[p].at(box.lo[0], j, k);
      for (int i = 0; i < n; ++i) {
        out[2 * i] += 0.75f * m[i + 1] + 0.25f * m[i];
        out[2 * i + 1] += 0.75f * m[i + 1] + 0.25f * m[i + 2];
      }
    });
  }
}

}  // namespace

Multilevel::MgLevel::MgLevel(PressureGrid g)
    : grid(std::move(g)), e(grid.level()), rhs(grid.level()), relaxation(grid.level())
{
  for (int p = 0; p < grid.level().local_count(); ++p) {
    const IndexBox& box = grid.level().local_box(p);
    Array3<float>& diagonal = relaxation[p];
    for_each_index(box, [&](int i, int j, int k) { diagonal(i, j, k) = 6.0f; });
    for (const SidePlane<float>& theta : grid.shares(p)) {
      const auto d = static_cast<std::size_t>(side_direction(theta.side));
      IndexBox layer = box;
      (side_is_high(theta.side) ? layer.lo[d] : layer.hi[d]) =
          side_is_high(theta.side) ? box.hi[d] - 1 : box.lo[d] + 1;
      for_each_index(layer, [&](int i, int j, int k) {
        const Int3 at{i, j, k};
        diagonal(i, j, k) -=
            1 - 2 * theta(at[static_cast<std::size_t>(theta.t1)], at[static_cast<std::size_t>(theta.t2)]);
      });
    }
    for_each_index(box,
                   [&](int i, int j, int k) { diagonal(i, j, k) = kOverRelaxation / diagonal(i, j, k); });
  }
}

Multilevel::Multilevel(const PressureGrid& finest)
{
  PressureGrid grid = finest;
  levels_.emplace_back(grid);
  while (grid.level().can_coarsen()) {
    grid = grid.coarsened();
    levels_.emplace_back(grid);
  }
  base_ = std::make_unique<HyprePfmg>(levels_.back().grid, 1);
}

void Multilevel::smooth(MgLevel& m, CellField<float>& e, bool from_zero)
{
  const Level& level = m.grid.level();
  float increment[kLongestRow];
  for (int colour = 0; colour < 2; ++colour) {
    for (int p = 0; p < level.local_count(); ++p) {
      const IndexBox& box = level.local_box(p);
      const int n = box.size(0);
      const std::ptrdiff_t sy = e[p].stride(1), sz = e[p].stride(2);
      for_each_row(box, [&](int j, int k) {
        const float* __restrict mask = colour_mask(((box.lo[0] + j + k + colour) & 1) == 0);
        const float* __restrict w = m.relaxation[p].at(box.lo[0], j, k);
        const float* __restrict rhs = m.rhs[p].at(box.lo[0], j, k);
        float* row = e[p].at(box.lo[0], j, k);
        if (from_zero && colour == 0) {
          for (int i = 0; i < n; ++i) row[i] = mask[i] * w[i] * rhs[i];
          return;
        }
        residual_row(increment, rhs, row, sy, sz, n);
        for (int i = 0; i < n; ++i) row[i] += mask[i] * w[i] * increment[i];
      });
    }
    m.grid.fill_ghosts(e);
  }
}

void Multilevel::cycle(std::size_t l, CellField<float>& e)
{
  MgLevel& m = levels_[l];
  if (l + 1 == levels_.size()) {
    base_->solve(m.rhs, e);
    m.grid.fill_ghosts(e);
    return;
  }
  MgLevel& coarse = levels_[l + 1];
  smooth(m, e, true);
  restrict_residual(coarse.grid.level(), m.rhs, e, coarse.rhs);
  cycle(l + 1, coarse.e);
  add_prolongation(m.grid.level(), coarse.e, e);
  m.grid.fill_ghosts(e);
  smooth(m, e, false);
}

void Multilevel::apply(const CellField<double>& r, CellField<float>& z)
{
  const Level& level = levels_[0].grid.level();
  for (int p = 0; p < level.local_count(); ++p) {
    const IndexBox& box = level.local_box(p);
    for_each_row(box, [&](int j, int k) {
      const double* from = r[p].at(box.lo[0], j, k);
      float* to = levels_[0].rhs[p].at(box.lo[0], j, k);
      for (int i = 0; i < box.size(0); ++i) to[i] = static_cast<float>(from[i]);
    });
  }
  cycle(0, z);
}

}  // namespace valsalva::ib3d
