// Elastic forces of a fibre network and their tangent; X, F, v, Kv hold one vector per node.
//   E = sum_springs (k l0/2)(l/l0 - 1)^2  +  sum_beams c |(X2 - X1)/l2 - (X1 - X0)/l1|^2/(l1 + l2)
//     + sum_tethers (kappa/2)|target - X|^2                                        [dyn cm]
//   F = -dE/dX                                                                     [dyn]
//   K v = -dF/dX v                                                                 [dyn, for v in cm]
// A tension-only spring shorter than its rest length has neither energy, force nor stiffness. A spring of
// length zero has no direction and exerts no force. X in cm.
#pragma once

#include <span>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// F += the elastic force (dyn) at the positions X (cm), node_count entries each.
void add_fibre_force(const FibreNetwork& network, std::span<const Vec3> X, std::span<Vec3> F);

/// Elastic energy at X, dyn cm.
double fibre_energy(const FibreNetwork& network, std::span<const Vec3> X);

/// How slack tension-only springs count in the stiffness: not at all (the exact tangent), or as if just taut along
/// their line (a bound on what the next instant can bring, for the stable step).
enum class SlackSprings { loose, just_taut };

/// Kv += the action of the tangent stiffness at X on the displacement v.
void add_fibre_stiffness_times(const FibreNetwork& network, std::span<const Vec3> X, std::span<const Vec3> v,
                               std::span<Vec3> Kv, SlackSprings slack = SlackSprings::loose);

}  // namespace valsalva::ib3d
