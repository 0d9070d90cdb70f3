#include "ib3d/structure/fold_relaxation.hpp"

#include <vector>

namespace valsalva::ib3d {

void add_fold_slip(const FiberNetwork& network, std::span<const Vec3> X, double time, std::span<Vec3> U)
{
  std::vector<Vec3> F(X.size(), Vec3{0.0, 0.0, 0.0});
  std::vector<double> row_sums(X.size(), 0.0);
  const Beams& beams = network.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const auto i0 = static_cast<std::size_t>(beams.x0[n]), i1 = static_cast<std::size_t>(beams.x1[n]),
               i2 = static_cast<std::size_t>(beams.x2[n]);
    const double g0 = 1.0 / beams.l1[n], g2 = 1.0 / beams.l2[n];
    const double c = 2.0 * beams.rigidity[n] / (beams.l1[n] + beams.l2[n]);
    const double row = 2.0 * c * (g0 + g2);
    row_sums[i0] += row * g0;
    row_sums[i1] += row * (g0 + g2);
    row_sums[i2] += row * g2;
    const Vec3 turn = g2 * (X[i2] - X[i1]) - g0 * (X[i1] - X[i0]);
    const double size = norm(turn);
    if (size <= kSharpestTurn) continue;
    const Vec3 bend = (c * (1.0 - kSharpestTurn / size)) * turn;
    F[i0] -= g0 * bend;
    F[i1] += (g0 + g2) * bend;
    F[i2] -= g2 * bend;
  }
  for (int node : network.tethers.node) row_sums[static_cast<std::size_t>(node)] = 0.0;
  for (std::size_t n = 0; n < X.size(); ++n)
    if (row_sums[n] > 0.0) U[n] += (1.0 / (time * row_sums[n])) * F[n];
}

}  // namespace valsalva::ib3d
