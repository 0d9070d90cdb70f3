// One level of the pressure problem: -lap p = r in cells, with the pressure condition of every side.
// Ghost rule (one layer): wall g = p1; prescribed pressure g = (1 - 2 theta) p1 + 2 theta p_b, with theta the
// share of the boundary face that carries a prescribed pressure p_b. Ghosts between patches come from the
// halo, at the edge of a refined level from `PressureInterface`. In the solver the operator is used without its factor
// 1/h^2:  (A p)_c = 6 p_c - sum of the six neighbours.
#pragma once

#include <vector>

#include "ib3d/fluid/pressure/openings.hpp"
#include "ib3d/grid/halo.hpp"

namespace valsalva::ib3d {

/// Prescribed pressure p_b (dyn/cm^2) on the boundary faces, laid out like PressureGrid::shares of a patch.
using BoundaryPressure = std::vector<std::vector<SidePlane<double>>>;

/// Sets p_b on one face of an opening; `p_b` has one entry per level.
void set_boundary_pressure(std::vector<BoundaryPressure>& p_b, const OpeningFaces::Face& face, double value);

class PressureGrid {
 public:
  /// Level l of the grid.
  PressureGrid(const Hierarchy& grid, int l, const std::vector<Opening>& openings);

  const Level& level() const { return level_; }
  /// theta of local patch p, one plane per non-periodic domain side it touches.
  const std::vector<SidePlane<float>>& shares(int p) const { return shares_[static_cast<std::size_t>(p)]; }
  /// Whether no side prescribes a pressure, so that p is defined up to a constant. Same on all ranks.
  bool singular() const { return singular_; }
  /// Zeros in the layout of `shares`.
  BoundaryPressure zero_boundary_pressure() const;

  /// Fills all ghosts for p_b = 0. Collective.
  template <class T>
  void fill_ghosts(CellField<T>& p) const;
  /// Adds 2 theta p_b to the ghosts that `fill_ghosts` has filled (not to those at edges and corners).
  void add_prescribed(CellField<double>& p, const BoundaryPressure& p_b) const;

  /// The next coarser grid of the multigrid: boxes halved, theta = 1.25 x the mean of the four finer faces,
  /// at most 1, so that a small disc does not vanish. Requires level().can_coarsen().
  PressureGrid coarsened() const;

 private:
  PressureGrid() = default;
  Level level_;
  std::vector<std::vector<SidePlane<float>>> shares_,
      reflections_;  ///< theta; 1 - 2 theta with a ring of ghosts
  bool singular_ = false;
  std::vector<Halo> halo_;  ///< exactly one; a vector so that the grid can be built in two steps
};

}  // namespace valsalva::ib3d
