// Response of the flow to the opening pressures. psi_k solves lap psi = 0 with psi = 1 on opening k, 0 on the
// other pressure faces, d psi/dn = 0 on walls. Changing the opening pressures by phi changes pressure and
// flows exactly by
//     p += sum_k phi_k psi_k,    Q -= dt W phi,    W_jk = (1/rho) x outward flux of grad psi_k through
//     opening j,
// so no second pressure solve is needed to couple the 0D network implicitly. For a straight tube between two
// openings 1/W_00 is the inertance rho l/A. (docs/scheme.md, section 4)
#pragma once

#include <Eigen/Dense>

#include "ib3d/fluid/pressure/pressure_solver.hpp"

namespace valsalva::ib3d {

class OpeningModes {
 public:
  /// Solves for all psi_k. Collective.
  OpeningModes(const OpeningFaces& openings, PressureSolver& solver, double density);

  /// W, openings x openings, in cm^4/g (ml/s per s per dyn/cm^2). Singular when walls close the rest.
  const Eigen::MatrixXd& conductance() const { return conductance_; }
  /// p += sum_m phi_m psi_m in plane k of a local patch, ghosts included. phi in dyn/cm^2.
  void add_to_plane(const std::vector<double>& phi, int level, int patch, int k, Array3<double>& p) const;

 private:
  std::vector<CompositeCells<double>> psi_;  ///< per opening
  Eigen::MatrixXd conductance_;
};

}  // namespace valsalva::ib3d
