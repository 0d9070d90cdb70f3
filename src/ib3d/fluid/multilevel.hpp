// Multigrid preconditioner of the pressure problem, z ~ A^{-1} r: one V(1,1) cycle in single precision with
// red-black Gauss-Seidel (over-relaxation 1.15), full-weighting of cell means, trilinear prolongation, and
// hypre's PFMG at the base, where the boxes can be halved no more. Meant for flexible CG only: alone it
// stalls on the disc mode. (docs/scheme.md, section 3; design measured against PFMG and BoomerAMG there.)
#pragma once

#include <memory>
#include <vector>

#include "ib3d/fluid/hypre_pfmg.hpp"
#include "ib3d/fluid/preconditioner.hpp"

namespace valsalva::ib3d {

class Multilevel : public Preconditioner {
 public:
  /// Collective.
  explicit Multilevel(const PressureGrid& finest);
  /// z = one cycle for A z = scale r. Collective.
  void apply(const CellField<double>& r, double scale, CellField<float>& z) override;
  int level_count() const { return static_cast<int>(levels_.size()); }

 private:
  struct MgLevel {
    explicit MgLevel(PressureGrid g);
    PressureGrid grid;
    CellField<float> e, rhs, relaxation;  ///< relaxation = 1.15/diagonal
  };
  void cycle(std::size_t l, CellField<float>& e);
  void smooth(MgLevel& m, CellField<float>& e, bool from_zero);

  std::vector<MgLevel> levels_;
  std::unique_ptr<HyprePfmg> base_;
  std::vector<float> increment_, mask_;  ///< one plane of work space; 1, 0, 1, 0, ...
};

}  // namespace valsalva::ib3d
