// Which part of space each rank computes, by weighted recursive coordinate bisection: each plane divides the work in
// proportion to the ranks on its sides. All levels are cut by the same planes, moved to their own blocks, so that
// transfers between levels stay mostly on one rank.
#pragma once

#include <vector>

#include "ib3d/grid/index_box.hpp"

namespace valsalva::ib3d {

/// Measured cost of a fibre node in cells: spread, interpolation and force, about 170 to 110 ns.
inline constexpr double kNodeWeight = 1.5;

/// The boxes of one level before they are cut.
struct LevelBoxes {
  double h;   ///< cm
  int block;  ///< cells: cuts lie on its multiples
  std::vector<IndexBox> boxes;
};

class RecursiveBisection {
 public:
  /// `region` is the number of the rank.
  struct Piece {
    IndexBox box;
    int region;
  };

  /// Divides space into `count` regions with equal shares of the work on all levels. Throws CaseError("grid.finest_cm")
  /// when it is too small for that.
  RecursiveBisection(const std::vector<LevelBoxes>& levels, const std::vector<Vec3>& nodes, int count);

  /// The boxes of a level cut along the planes, without empty pieces, in the order of the regions.
  std::vector<Piece> cut(const LevelBoxes& level) const;

 private:
  /// A leaf is a region; otherwise [first, first + count) of the regions are split at x (cm) along d.
  struct Node {
    int first, count;
    int d = 0;
    double x = 0;
    int low = -1, high = -1;  ///< children, -1 for a leaf
  };
  struct Part;
  int split(Part part, int first, int count);
  void cut(int node, const IndexBox& box, const LevelBoxes& level, std::vector<Piece>& pieces) const;

  std::vector<Node> nodes_;
};

}  // namespace valsalva::ib3d
