// One level of the pressure problem: -lap p = r in cells, with the pressure condition of every side.
// Ghost rule (one layer): wall g = p1; prescribed pressure g = (1 - 2 theta) p1 + 2 theta p_b, with theta the
// share of the boundary face that carries a prescribed pressure p_b. Ghosts between patches come from the
// halo. In the multigrid the operator is used without its factor 1/h^2:  (A p)_c = 6 p_c - sum of the six
// neighbours.
#pragma once

#include <vector>

#include "ib3d/fluid/openings.hpp"
#include "ib3d/grid/halo.hpp"

namespace valsalva::ib3d {

/// Prescribed pressure p_b (dyn/cm^2) on the boundary faces, laid out like PressureGrid::shares of a patch.
using BoundaryPressure = std::vector<std::vector<SidePlane<double>>>;

class PressureGrid {
 public:
  PressureGrid(const Level& level, const std::vector<Opening>& openings);

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
  /// Fills all ghosts for the given p_b (edge and corner ghosts as for p_b = 0). Collective.
  void fill_ghosts(CellField<double>& p, const BoundaryPressure& p_b) const;

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

/// Sum of a b over all cells. Collective.
double dot(const Level& level, const CellField<double>& a, const CellField<double>& b);

}  // namespace valsalva::ib3d
