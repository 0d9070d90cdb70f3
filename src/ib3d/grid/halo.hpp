// Exchange of ghost values between the patches of one level, on one rank or across ranks, periodic images
// included.
//   fill        ghost <- value of the owner
//   accumulate  owner += ghost, the exact transpose of fill (ghosts are left as they are)
// Both are collective.
#pragma once

#include <vector>

#include "ib3d/grid/copy_plan.hpp"

namespace valsalva::ib3d {

class Halo {
 public:
  /// For one array of each of these centrings, exchanged in one message per neighbour rank.
  Halo(const Level& level, const std::vector<Centring>& centrings, int ghosts);

  static Halo for_cells(const Level& level, int ghosts) { return {level, {Centring::cell}, ghosts}; }
  static Halo for_faces(const Level& level, int ghosts = kMacGhosts)
  {
    return {level, {Centring::x_face, Centring::y_face, Centring::z_face}, ghosts};
  }

  /// Of a halo of the same centring; the field must store at least as many ghosts.
  template <class Field>
  void fill(Field& field) const
  {
    plan_.forward(field, field);
  }
  void accumulate(MacField& field) const { plan_.transpose(field, field); }

 private:
  CopyPlan plan_;
};

}  // namespace valsalva::ib3d
