// The pressure problem  -lap p = r  on all levels together (docs/scheme.md, section 3). Valid cells are those that no
// finer level covers; covered ones hold the mean of the finer values. Operator and residual carry the factor h_l^2 of
// their level (no division): (A p)_c = 6 p_c - sum of neighbours, except at the edge of a refined level, where the
// fluxes of the finer cells count. Fields have one entry per level. All calls are collective.
#pragma once

#include "ib3d/fluid/pressure/pressure_grid.hpp"
#include "ib3d/fluid/pressure/pressure_interface.hpp"
#include "ib3d/grid/coarse_fine.hpp"

namespace valsalva::ib3d {

/// Between every two neighbouring levels; entry l - 1 joins levels l - 1 and l. `ghosts`: see CoarseFine.
std::vector<CoarseFine> transfers_between_levels(const Hierarchy& grid, int ghosts = kMacGhosts);

class CompositePressure {
 public:
  /// `grid` and `transfers` must outlive the object.
  CompositePressure(const Hierarchy& grid, const std::vector<Opening>& openings,
                    std::vector<CoarseFine>& transfers);

  const Hierarchy& hierarchy() const { return hierarchy_; }
  const PressureGrid& grid(int l) const { return grids_[static_cast<std::size_t>(l)]; }
  /// Between levels l - 1 and l, l >= 1.
  PressureInterface& edge(int l) { return edges_[static_cast<std::size_t>(l) - 1]; }
  /// Whether no side prescribes a pressure.
  bool singular() const { return grids_[0].singular(); }
  /// One entry per level.
  std::vector<BoundaryPressure> zero_boundary_pressure() const;

  /// Averages down, then fills all ghosts; p_b as prescribed, or 0.
  void fill_ghosts(CompositeCells<float>& p) { fill(p, nullptr); }
  void fill_ghosts(CompositeCells<double>& p, const std::vector<BoundaryPressure>& p_b) { fill(p, &p_b); }

  /// r = h^2 (lap p - source div u) on valid cells, 0 on covered ones. Fills the ghosts of p. u (cm/s; may be null:
  /// no source) must agree across the edges of levels.
  void residual(CompositeCells<double>& p, const std::vector<BoundaryPressure>& p_b, const CompositeMac* u,
                double source, CompositeCells<float>& r);
  /// y = A d on valid cells of all levels, 0 on covered ones; fills the ghosts of d. Returns local sums over the
  /// valid cells of h_l d y and h_l d r.
  std::array<double, 2> apply(CompositeCells<float>& d, const CompositeCells<float>& r,
                              CompositeCells<float>& y);

  /// Sets the covered cells of level l to zero.
  template <class T>
  void zero_covered(int l, CellField<T>& a) const;

 private:
  template <class T>
  void fill(CompositeCells<T>& p, const std::vector<BoundaryPressure>* p_b);
  /// Replaces the gradients across the edge of level l + 1 in A p on level l by those of the finer cells.
  template <class T>
  void correct_edge(int l, const CompositeCells<T>& p, CellField<float>& y, float sign);

  const Hierarchy& hierarchy_;
  std::vector<CoarseFine>& transfers_;
  std::vector<PressureGrid> grids_;
  std::vector<PressureInterface> edges_;
};

/// Calls f(level, patch, i, j, k, n) for the first cell (i, j, k) and the length of every row of all local patches.
template <class F>
void for_each_local_row(const Hierarchy& grid, F&& f)
{
  for (int l = 0; l < grid.level_count(); ++l)
    for (int p = 0; p < grid.level(l).local_count(); ++p) {
      const IndexBox& box = grid.level(l).local_box(p);
      for_each_row(box,
                   [&](int j, int k) { f(static_cast<std::size_t>(l), p, box.lo[0], j, k, box.size(0)); });
    }
}

}  // namespace valsalva::ib3d
