#include "ib3d/fluid/pressure/multilevel.hpp"

#include <algorithm>

#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

constexpr float kOverRelaxation = 1.15f;
/// The cells of plane k of a box as one run of memory, from its first cell to its last. The x ghosts between the rows
/// are swept along: with an odd row stride the colours of the checkerboard alternate through them, and their
/// relaxation factor is zero. One long loop instead of many short ones.
struct Plane {
  std::ptrdiff_t length;
  std::ptrdiff_t sy, sz;
  Plane(const IndexBox& box, const Array3<float>& a)
      : length((box.size(1) - 1) * a.stride(1) + box.size(0)), sy(a.stride(1)), sz(a.stride(2))
  {
  }
};

/// t = rhs - (6 e - neighbours).
inline void residual(float* __restrict t, const float* __restrict rhs, const float* __restrict e, Plane plane)
{
  for (std::ptrdiff_t i = 0; i < plane.length; ++i)
    t[i] = rhs[i] - 6 * e[i] + neighbours(e, i, plane.sy, plane.sz);
}

/// Increment of the relaxation on one colour; in two passes, since updating in place stalls on its own stores.
inline void relax(float* __restrict e, float* __restrict t, const float* __restrict rhs,
                  const float* __restrict w, const float* __restrict mask, Plane plane)
{
  for (std::ptrdiff_t i = 0; i < plane.length; ++i)
    t[i] = mask[i] * w[i] * (rhs[i] - 6 * e[i] + neighbours(e, i, plane.sy, plane.sz));
  for (std::ptrdiff_t i = 0; i < plane.length; ++i) e[i] += t[i];
}

/// The same from e = 0.
inline void relax_zero(float* __restrict e, const float* __restrict rhs, const float* __restrict w,
                       const float* __restrict mask, Plane plane)
{
  for (std::ptrdiff_t i = 0; i < plane.length; ++i) e[i] = mask[i] * w[i] * rhs[i];
}

inline void sum_pairs(float* __restrict out, const float* __restrict a, const float* __restrict b,
                      const float* __restrict c, const float* __restrict d, int n)
{
  for (int i = 0; i < n; ++i)
    out[i] = 0.5f * ((a[2 * i] + a[2 * i + 1]) + (b[2 * i] + b[2 * i + 1]) + (c[2 * i] + c[2 * i + 1]) +
                     (d[2 * i] + d[2 * i + 1]));
}

/// rhs of the coarser level = h_c^2 x mean of the residual over the eight fine cells (h^2 scaling: 4 x mean).
void restrict_residual(const Level& coarse, const Level& fine, const CellField<float>& rhs,
                       const CellField<float>& e, CellField<float>& coarse_rhs)
{
  std::vector<float> low, high;
  for (int p = 0; p < coarse.local_count(); ++p) {
    const IndexBox &box = coarse.local_box(p), &fine_box = fine.local_box(p);
    const Plane plane(fine_box, e[p]);
    low.resize(static_cast<std::size_t>(plane.length));
    high.resize(low.size());
    const int i = fine_box.lo[0], j0 = fine_box.lo[1];
    for (int k = box.lo[2]; k < box.hi[2]; ++k) {
      residual(low.data(), rhs[p].at(i, j0, 2 * k), e[p].at(i, j0, 2 * k), plane);
      residual(high.data(), rhs[p].at(i, j0, 2 * k + 1), e[p].at(i, j0, 2 * k + 1), plane);
      for (int j = box.lo[1]; j < box.hi[1]; ++j) {
        const std::ptrdiff_t row = (2 * j - j0) * plane.sy;
        sum_pairs(coarse_rhs[p].at(box.lo[0], j, k), low.data() + row, low.data() + row + plane.sy,
                  high.data() + row, high.data() + row + plane.sy, box.size(0));
      }
    }
  }
}

/// mixed = the coarse values at the height and depth of a fine row: own row with 3/4, the nearer neighbours with 1/4.
inline void mix_row(float* __restrict mixed, const float* __restrict c, std::ptrdiff_t to_y,
                    std::ptrdiff_t to_z, int n)
{
  for (int i = 0; i < n; ++i)
    mixed[i] = 0.5625f * c[i] + 0.1875f * (c[i + to_y] + c[i + to_z]) + 0.0625f * c[i + to_y + to_z];
}

/// e += interpolation of the mixed row, whose first value belongs to the coarse cell before the first.
inline void add_interpolated_row(float* __restrict e, const float* __restrict m, int n)
{
  for (int i = 0; i < n; ++i) {
    e[2 * i] += 0.75f * m[i + 1] + 0.25f * m[i];
    e[2 * i + 1] += 0.75f * m[i + 1] + 0.25f * m[i + 2];
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
      mix_row(mixed.data(), coarse[p].at(box.lo[0] / 2 - 1, j >> 1, k >> 1), (j & 1) != 0 ? sy : -sy,
              (k & 1) != 0 ? sz : -sz, n + 2);
      add_interpolated_row(e[p].at(box.lo[0], j, k), mixed.data(), n);
    });
  }
}

}  // namespace

/// Transfer from a refined level to the composite level below it, whose boxes and owners are others.
struct Multilevel::Transfer {
  Level coarsened;  ///< the refined level's boxes in coarse cells
  CellField<float> rhs, e;
  CopyPlan down, up;

  Transfer(const Level& coarse, const Level& fine)
      : coarsened(fine.coarsened()), rhs(coarsened), e(coarsened), down(coarse.comm), up(coarse.comm)
  {
    for_each_overlap(coarsened, coarse, [&](std::size_t f, std::size_t c, const Int3& shift) {
      const Patch &from = coarsened.patches[f], &to = coarse.patches[c];
      down.add(from, to, shift, Centring::cell, from.box, to.box);
    });
    for (const Patch& to : coarsened.patches)
      up.add_sources(coarse, to, Centring::cell, to.box.grown(1),
                     [&](const IndexBox& cells) { return coarse.with_outside(cells, cells, 1); });
  }
};

Multilevel::MgLevel::MgLevel(PressureGrid g, PressureInterface* level_edge)
    : grid(std::move(g)), edge(level_edge), relaxation(grid.level())
{
  for (int p = 0; p < grid.level().local_count(); ++p) {
    const IndexBox& box = grid.level().local_box(p);
    Array3<float>& diagonal = relaxation[p];
    for_each_index(box, [&](int i, int j, int k) { diagonal(i, j, k) = 6.0f; });
    for (const SidePlane<float>& theta : grid.shares(p)) {
      theta.for_each(box.cells_inside(theta.side), [&](const Int3& at, int a, int b) {
        diagonal(at[0], at[1], at[2]) -= 1 - 2 * theta(a, b);
      });
    }
    if (edge != nullptr)
      edge->for_each_edge_cell(p, [&](int i, int j, int k) { diagonal(i, j, k) -= 2.0f / 3; });
    for_each_index(box,
                   [&](int i, int j, int k) { diagonal(i, j, k) = kOverRelaxation / diagonal(i, j, k); });
  }
}

void Multilevel::MgLevel::fill_ghosts(CellField<float>& a) const
{
  grid.fill_ghosts(a);
  if (edge != nullptr) edge->fill_ghosts(a);
}

Multilevel::Multilevel(CompositePressure& problem)
    : composite_levels_(static_cast<std::size_t>(problem.hierarchy().level_count()))
{
  for (int l = problem.hierarchy().level_count() - 1; l >= 0; --l) {
    levels_.emplace_back(problem.grid(l), l > 0 ? &problem.edge(l) : nullptr);
    if (levels_.size() > 1) levels_.back().rhs = CellField<float>(problem.grid(l).level());
    if (l > 0)
      levels_.back().transfer =
          std::make_unique<Transfer>(problem.hierarchy().level(l - 1), problem.hierarchy().level(l));
  }
  while (levels_.back().grid.level().can_coarsen()) {
    levels_.emplace_back(levels_.back().grid.coarsened(), nullptr);
    MgLevel& m = levels_.back();
    m.rhs = m.e = CellField<float>(m.grid.level());
  }
  base_ = std::make_unique<HyprePfmg>(levels_.back().grid, 2);
}

Multilevel::~Multilevel() = default;

void Multilevel::smooth(const MgLevel& m, const CellField<float>& rhs, CellField<float>& e, bool from_zero,
                        bool ghosts_wanted)
{
  const Level& level = m.grid.level();
  for (int colour = 0; colour < 2; ++colour) {
    for (int p = 0; p < level.local_count(); ++p) {
      const IndexBox& box = level.local_box(p);
      const Plane plane(box, e[p]);
      if (static_cast<std::size_t>(plane.length) > increment_.size()) {
        increment_.resize(static_cast<std::size_t>(plane.length));
        mask_.resize(increment_.size() + 1);
        for (std::size_t i = 0; i < mask_.size(); ++i) mask_[i] = i % 2 == 0 ? 1.0f : 0.0f;
      }
      const int i = box.lo[0], j = box.lo[1];
      for (int k = box.lo[2]; k < box.hi[2]; ++k) {
        const float* mask = mask_.data() + ((i + j + k + colour) & 1);
        if (from_zero && colour == 0)
          relax_zero(e[p].at(i, j, k), rhs[p].at(i, j, k), m.relaxation[p].at(i, j, k), mask, plane);
        else
          relax(e[p].at(i, j, k), increment_.data(), rhs[p].at(i, j, k), m.relaxation[p].at(i, j, k), mask,
                plane);
      }
    }
    if (colour == 0 || ghosts_wanted) m.fill_ghosts(e);
  }
}

/// One V-cycle for A e = rhs on level l (0 the finest) and below.
void Multilevel::cycle(std::size_t l, const CellField<float>& rhs, CellField<float>& e)
{
  MgLevel& m = levels_[l];
  if (l + 1 == levels_.size()) {
    base_->solve(rhs, e);
    m.grid.fill_ghosts(e);
    return;
  }
  MgLevel& coarse = levels_[l + 1];
  CellField<float>& coarse_e = l + 1 < composite_levels_ ? (*z_)[composite_levels_ - 2 - l] : coarse.e;
  if (m.edge != nullptr) m.edge->zero_base();
  smooth(m, rhs, e, true, true);
  if (m.transfer == nullptr) {
    restrict_residual(coarse.grid.level(), m.grid.level(), rhs, e, coarse.rhs);
    cycle(l + 1, coarse.rhs, coarse_e);
    add_prolongation(m.grid.level(), coarse_e, e);
  } else {
    Transfer& t = *m.transfer;
    restrict_residual(t.coarsened, m.grid.level(), rhs, e, t.rhs);
    t.down.forward(t.rhs, coarse.rhs);
    m.edge->for_each_flux(e, [&](int patch, const Int3& c, Side, double jumps) {
      coarse.rhs[patch](c[0], c[1], c[2]) -= static_cast<float>(0.5 * jumps);
    });
    cycle(l + 1, coarse.rhs, coarse_e);
    t.up.forward(coarse_e, t.e);
    add_prolongation(m.grid.level(), t.e, e);
    m.edge->take_base(coarse_e);
  }
  m.fill_ghosts(e);
  smooth(m, rhs, e, false, l > 0);
}

void Multilevel::apply(const CompositeCells<float>& r, CompositeCells<float>& z)
{
  z_ = &z;
  // Covered cells of the coarser levels get their right-hand side from the finer one, valid ones from r.
  for (std::size_t l = 1; l < composite_levels_; ++l)
    for (int p = 0; p < levels_[l].rhs.patch_count(); ++p)
      std::copy(r[composite_levels_ - 1 - l][p].data().begin(), r[composite_levels_ - 1 - l][p].data().end(),
                levels_[l].rhs[p].data().begin());
  cycle(0, r.back(), z.back());
}

}  // namespace valsalva::ib3d
