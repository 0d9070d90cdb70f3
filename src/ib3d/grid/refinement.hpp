// Where the grid is fine: around the structure (always on the finest level), inside what it encloses, in boxes by hand,
// where the flow has vorticity; and on every coarser level around the finer ones (proper nesting).
#pragma once

#include <span>

#include "ib3d/grid/cluster.hpp"

namespace valsalva::ib3d {

/// Cells of level l between the edge of level l + 1 and its own edge.
inline constexpr int kNestingBuffer = 4;
/// Cells from a node to the end of its delta support, rounded up.
inline constexpr int kSupportCells = 3;

/// A box that is to be refined.
struct RefinedRegion {
  Vec3 lo{}, hi{};  ///< cm
  int level = 1;    ///< the level that covers it, and with it all coarser ones
};

/// Keys of [grid] and [[refine]].
struct RefinementPolicy {
  int levels = 1;
  int margin_cells = 2;  ///< how far (finest cells) nodes and vorticity may move before the grid follows
  bool lumen = true;     ///< refine what the structure encloses, layer by layer across z
  double vorticity = 0;  ///< refine where |curl u| is larger (1/s); 0: nowhere
  std::vector<RefinedRegion> regions;  ///< by hand
};

/// Boxes of levels 1, 2, ...: h (cm) is the finest spacing, `nodes` are the structure's positions (cm), `moving` regions
/// that the flow carries along; nodes and these get the margin. Throws CaseError("grid.finest_cm") when h does not divide
/// the domain.
Refinement refine(const Domain& domain, double h, const RefinementPolicy& policy, std::span<const Vec3> nodes,
                  std::span<const RefinedRegion> moving = {});

}  // namespace valsalva::ib3d
