#include "ib3d/structure/fibres/fold_relaxation.hpp"

#include <vector>

#include "ib3d/structure/fibres/beam.hpp"

namespace valsalva::ib3d {

void add_fold_slip(const FibreNetwork& network, std::span<const Vec3> X, double time, std::span<Vec3> U)
{
  std::vector<Vec3> F(X.size(), Vec3{0.0, 0.0, 0.0});
  std::vector<double> row_sums(X.size(), 0.0);
  const Beams& beams = network.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const Beam beam(beams, n);
    const double row = 2.0 * beam.stiffness * (beam.g0 + beam.g2);
    row_sums[beam.i0] += row * beam.g0;
    row_sums[beam.i1] += row * (beam.g0 + beam.g2);
    row_sums[beam.i2] += row * beam.g2;
    const Vec3 turn = beam.turn(X);
    const double size = norm(turn);
    if (size > kSharpestTurn) beam.add_force((beam.stiffness * (1.0 - kSharpestTurn / size)) * turn, F);
  }
  for (int node : network.tethers.node) row_sums[static_cast<std::size_t>(node)] = 0.0;
  for (std::size_t n = 0; n < X.size(); ++n)
    if (row_sums[n] > 0.0) U[n] += (1.0 / (time * row_sums[n])) * F[n];
}

}  // namespace valsalva::ib3d
