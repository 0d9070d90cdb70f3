// Transfers between two neighbouring levels of the hierarchy, refinement ratio 2.
//   average_down   coarse value <- mean of the four fine faces or eight fine cells that make it up
//   interpolate    fine values from coarse ones, one direction after the other: quadratic along cell-centred
//                  directions (c + s/8 (c_+ - c_-), s = -1, +1 for the lower and upper half: keeps the mean), along
//                  the normal of faces the coarse face itself or the cubic mean (-1, 9, 9, -1)/16 between two
//   fill_ghosts    the ghosts of fine velocities that no fine patch covers, by interpolation
// All are collective. Coarse values must have their ghosts filled where they are read.
#pragma once

#include "ib3d/grid/copy_plan.hpp"

namespace valsalva::ib3d {

class CoarseFine {
 public:
  /// Both levels must outlive the object. `ghosts`: layers that fill_ghosts fills.
  CoarseFine(const Level& coarse, const Level& fine, int ghosts = kMacGhosts);

  /// Faces or cells of the coarse level under the fine one.
  void average_down(const MacField& fine, MacField& coarse);
  /// Only those faces at the fine patches' sides: all that the divergence of valid coarse cells reads.
  void average_down_edges(const MacField& fine, MacField& coarse);
  template <class T>
  void average_down(const CellField<T>& fine, CellField<T>& coarse);
  /// Fills the ghosts beyond the fine level's edge inside the domain; the level's own exchange and the sides
  /// of the domain come after it.
  void fill_ghosts(const MacField& coarse, MacField& fine);
  /// All faces of the fine patches, or all their cells.
  void interpolate(const MacField& coarse, MacField& fine);
  void interpolate(const CellField<double>& coarse, CellField<double>& fine);

  /// Coarse cells under fine ones, per local coarse patch.
  const std::vector<std::vector<IndexBox>>& covered() const { return covered_; }

 private:
  /// Ghost faces of one local fine patch that lie in coarse cells only.
  struct GhostPart {
    int patch;
    Centring centring;
    IndexBox faces;
  };
  /// Adds to a plan what fetches the coarse values that these values of a fine patch are interpolated from.
  void plan_footprint(CopyPlan& plan, const Patch& to, Centring c, const IndexBox& values) const;
  template <class Field>
  void interpolate(const Field& coarse, Field& shadow, Field& fine,
                   const std::vector<Centring>& centrings) const;
  /// Means of the fine faces into `faces` (coarse indices) of the shadow.
  void average(const MacField& fine, int patch, int component, const IndexBox& faces);
  CellField<double>& means(double) { return cells_; }
  CellField<float>& means(float) { return cells_float_; }

  const Level &coarse_, &fine_;
  Level coarsened_;
  std::vector<std::vector<IndexBox>> covered_;
  std::vector<GhostPart> ghosts_;
  CopyPlan down_faces_, down_edges_, down_cells_, up_ghosts_;
  MacField shadow_;  ///< the coarse level as the fine patches see it
  CellField<double> cells_;
  CellField<float> cells_float_;
};

}  // namespace valsalva::ib3d
