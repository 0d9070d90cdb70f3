// The implicit half of Crank-Nicolson viscosity: (1 - (nu dt/2) lap) u = b for the three components on the faces of all
// levels (docs/scheme.md, 2.7). With a = nu dt/(2 h^2) a Jacobi sweep is
//     u <- (b + a sum of the six neighbours)/(1 + 6 a)
// and shrinks the error to 6 a/(1 + 6 a) of it: for blood, where a is of the order of 0.01, a few sweeps reach rounding.
// u, b: cm/s. Collective.
#pragma once

#include <functional>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

class ViscousSolver {
 public:
  /// Work space for all levels. `grid` must outlive the object.
  explicit ViscousSolver(const Hierarchy& grid);

  /// Replaces b in u by the solution, ghosts filled, and returns the number of sweeps. diffusion = nu dt/2 (cm^2);
  /// `guess` has its ghosts filled; complete(v) imposes what holds beside the equation: closed walls, means on
  /// covered faces, ghosts. Sweeps end when u changes by less than 1e-9 of its largest value; throws SolverError if
  /// that takes too many, or where a number is not finite.
  int solve(double diffusion, const CompositeMac& guess, CompositeMac& u,
            const std::function<void(CompositeMac&)>& complete);

 private:
  void sweep(double diffusion, const CompositeMac& from, CompositeMac& to) const;
  double relative_change(const CompositeMac& a, const CompositeMac& b) const;

  const Hierarchy& grid_;
  CompositeMac b_, before_;
};

}  // namespace valsalva::ib3d
