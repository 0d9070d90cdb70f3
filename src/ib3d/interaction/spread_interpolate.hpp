// The two exchanges of the immersed boundary method, with the 4-point delta function on the MAC grid:
//   spread        f(x) = sum_k F_k delta_h(x - X_k)         f = S F    (dyn -> dyn/cm^3)
//   interpolate   U_k  = sum_x u(x) delta_h(x - X_k) h^3    U = J u    (cm/s)
// Exact adjoints, <u, S F> h^3 = <J u, F>, up to the sides of the domain: there both mirror the points of the support
// that lie outside, so that all weights still sum to one and the total force is conserved too. (Reading J off no-slip
// ghosts instead, with the sign changed, would leave the last half cell beside a side without any constraint: a tube
// that ends on the side then leaks around its rim; measured 7 ml/s at 85 mmHg and h = 10/96 cm.)
// Nodes are grouped by the local patch under them: patch p has nodes [first[p], first[p+1]).
#pragma once

#include <span>
#include <vector>

#include "ib3d/grid/halo.hpp"

namespace valsalva::ib3d {

/// How far (cells) a node may drift out of its patch before the nodes have to be distributed anew.
inline constexpr double kNodeDrift = 1.0;

/// U = J[X] u on one level; the ghosts of u must be filled.
void interpolate(const Level& level, std::span<const int> first, std::span<const Vec3> X, const MacField& u,
                 std::span<Vec3> U);

class Interaction {
 public:
  /// On the finest level, which must outlive the object.
  explicit Interaction(const Level& level) : level_(&level), faces_(Halo::for_faces(level, kNodeGhosts)) {}

  /// f = S[X] F on the owned faces; f is overwritten, ghosts included. Forces on wall faces are lost to the
  /// wall. Collective.
  void spread(std::span<const int> first, std::span<const Vec3> X, std::span<const Vec3> F,
              MacField& f) const;
  /// The same on its level.
  void interpolate(std::span<const int> first, std::span<const Vec3> X, const MacField& u,
                   std::span<Vec3> U) const
  {
    ib3d::interpolate(*level_, first, X, u, U);
  }
  /// Fills the ghosts of a velocity that `interpolate` reads: those between patches. Collective.
  void fill_ghosts(MacField& u) const { faces_.fill(u); }

 private:
  const Level* level_;
  Halo faces_;
};

}  // namespace valsalva::ib3d
