// hypre's structured multigrid PFMG for the pressure operator of one grid (A = 6 - neighbours, sides
// included). Serves as the base of `Multilevel` and, one cycle at a time, as the selectable full
// preconditioner "pfmg".
#pragma once

#include <memory>

#include "ib3d/fluid/pressure/preconditioner.hpp"
#include "ib3d/fluid/pressure/pressure_grid.hpp"

namespace valsalva::ib3d {

class HyprePfmg : public Preconditioner {
 public:
  /// `cycles` V(1,1) cycles per call, from a zero guess. Collective. Throws SolverError when hypre reports an
  /// error.
  HyprePfmg(const PressureGrid& grid, int cycles);
  ~HyprePfmg() override;
  HyprePfmg(const HyprePfmg&) = delete;
  HyprePfmg& operator=(const HyprePfmg&) = delete;

  /// On a hierarchy of one level.
  void apply(const CompositeCells<float>& r, CompositeCells<float>& z) override { solve(r.at(0), z.at(0)); }
  /// z ~ A^{-1} r on the one level, ghosts of z left alone. Collective. SolverError as above.
  void solve(const CellField<float>& r, CellField<float>& z);

 private:
  struct Handles;
  std::unique_ptr<Handles> hypre_;
};

}  // namespace valsalva::ib3d
