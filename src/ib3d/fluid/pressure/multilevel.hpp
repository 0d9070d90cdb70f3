// Multigrid preconditioner of the composite pressure problem, z ~ A^{-1} r: one V(1,1) cycle over all levels in
// single precision with red-black Gauss-Seidel (over-relaxation 1.15), full-weighting of cell means, trilinear
// prolongation. Refined levels correct the coarser ones under and beside them; below level 0 boxes are halved as long
// as they can be, and hypre's PFMG solves at the base. Meant for flexible CG only: alone it stalls on the disc mode.
// (docs/scheme.md, section 3; design measured against PFMG and BoomerAMG there.)
#pragma once

#include <memory>
#include <vector>

#include "ib3d/fluid/pressure/composite_pressure.hpp"
#include "ib3d/fluid/pressure/hypre_pfmg.hpp"

namespace valsalva::ib3d {

class Multilevel : public Preconditioner {
 public:
  /// `problem` must outlive the object. Collective.
  explicit Multilevel(CompositePressure& problem);
  ~Multilevel() override;
  void apply(const CompositeCells<float>& r, CompositeCells<float>& z) override;

 private:
  struct Transfer;
  struct MgLevel {
    MgLevel(PressureGrid g, PressureInterface* level_edge);
    void fill_ghosts(CellField<float>& a) const;
    PressureGrid grid;
    PressureInterface* edge;  ///< of a refined level, else null
    std::unique_ptr<Transfer> transfer;
    CellField<float> relaxation;  ///< 1.15/diagonal
    CellField<float> rhs;         ///< of all but the finest level
    CellField<float> e;           ///< of levels below level 0; the composite ones work in place
  };
  void cycle(std::size_t l, const CellField<float>& rhs, CellField<float>& e);
  void smooth(const MgLevel& m, const CellField<float>& rhs, CellField<float>& e, bool from_zero,
              bool ghosts_wanted);

  std::size_t composite_levels_;
  std::vector<MgLevel> levels_;  ///< finest first
  std::unique_ptr<HyprePfmg> base_;
  CompositeCells<float>* z_ = nullptr;   ///< during a cycle: the corrections of the composite levels
  std::vector<float> increment_, mask_;  ///< one plane of work space; 1, 0, 1, 0, ...
};

}  // namespace valsalva::ib3d
