// Exchange of ghost values between the patches of one level, on one rank or across ranks, periodic images
// included.
//   fill        ghost <- value of the owner
//   accumulate  owner += ghost, the exact transpose of fill (ghosts are left as they are)
// Both are collective.
#pragma once

#include <vector>

#include "ib3d/grid/copy_plan.hpp"

namespace valsalva::ib3d {

/// Where the values of one array sit: on the faces normal to x, y, z, or in cells.
enum class Centring { x_face = 0, y_face = 1, z_face = 2, cell = 3 };

class Halo {
 public:
  /// For groups of arrays with these centrings, exchanged in one message per neighbour rank.
  Halo(const Level& level, const std::vector<Centring>& centrings, int ghosts);

  static Halo for_cells(const Level& level, int ghosts) { return {level, {Centring::cell}, ghosts}; }
  static Halo for_faces(const Level& level, int ghosts = kMacGhosts)
  {
    return {level, {Centring::x_face, Centring::y_face, Centring::z_face}, ghosts};
  }

  /// Of a halo of the same centering; the field must store at least as many ghosts.
  template <class T>
  void fill(CellField<T>& field) const;
  void fill(MacField& field) const;
  void accumulate(MacField& field) const;

 private:
  CopyPlan plan_;
};

}  // namespace valsalva::ib3d
