// Fields carried over from one hierarchy to another of the same domain and coarsest spacing: where the old one had the
// level, its values; elsewhere interpolated from the next coarser level of the new one. New velocities have the
// divergence of the coarse cell they lie in: inside each of them the potential on the eight fine cells that removes
// what interpolation has left (the idea of Toth & Roe 2002). Collective.
#pragma once

#include "ib3d/grid/coarse_fine.hpp"

namespace valsalva::ib3d {

class Regrid {
 public:
  /// `transfers` are those of `after`; all three must outlive the object.
  Regrid(const Hierarchy& before, const Hierarchy& after, std::vector<CoarseFine>& transfers);

  /// Level l, once the levels below are complete with their ghosts. No ghosts are filled. `keep_divergence`: for
  /// velocities.
  void carry(int l, const CompositeMac& before, CompositeMac& after, bool keep_divergence) const;
  void carry(int l, const CompositeCells<double>& before, CompositeCells<double>& after) const;

 private:
  const Hierarchy &before_, &after_;
  std::vector<CoarseFine>& transfers_;
  std::vector<CopyPlan> faces_, cells_;  ///< per level that both have
};

/// Makes the divergence the same in the eight fine cells of every coarse cell of `coarse_cells`, by changing the twelve
/// faces inside it; u_d are the components on one patch of the fine level.
void even_out_divergence(const IndexBox& coarse_cells, const std::array<Array3<double>*, 3>& u);

}  // namespace valsalva::ib3d
