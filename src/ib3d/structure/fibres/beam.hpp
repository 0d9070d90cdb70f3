// One beam of a fibre network, the piece that its force, energy and slip share:
//   turn = (X2 - X1)/l2 - (X1 - X0)/l1     change of direction, about the angle (rad)
//   E    = rigidity |turn|^2/(l1 + l2)     erg,   force -dE/dX of a bend = 2 rigidity/(l1 + l2) turn   (docs/scheme.md, 1.3)
#pragma once

#include <span>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

struct Beam {
  std::size_t i0, i1, i2;  ///< its nodes, i1 in the middle
  double g0, g2;           ///< 1/l1, 1/l2, 1/cm
  double stiffness;        ///< 2 rigidity/(l1 + l2), dyn cm

  Beam(const Beams& beams, std::size_t n)
      : i0(static_cast<std::size_t>(beams.x0[n])),
        i1(static_cast<std::size_t>(beams.x1[n])),
        i2(static_cast<std::size_t>(beams.x2[n])),
        g0(1.0 / beams.l1[n]),
        g2(1.0 / beams.l2[n]),
        stiffness(2.0 * beams.rigidity[n] / (beams.l1[n] + beams.l2[n]))
  {
  }
  /// X: cm, one per node.
  Vec3 turn(std::span<const Vec3> X) const { return g2 * (X[i2] - X[i1]) - g0 * (X[i1] - X[i0]); }
  /// Adds the nodal forces (dyn) of `bend` (dyn cm) to F, one per node.
  void add_force(const Vec3& bend, std::span<Vec3> F) const
  {
    F[i0] -= g0 * bend;
    F[i1] += (g0 + g2) * bend;
    F[i2] -= g2 * bend;
  }
};

}  // namespace valsalva::ib3d
