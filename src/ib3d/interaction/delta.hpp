// Peskin's 4-point regularised delta function, delta_h(x) = phi(x/h) phi(y/h) phi(z/h) / h^3 (Peskin 2002,
// eq. 6.27):
//   phi(r) = (3 - 2|r| + sqrt(1 + 4|r| - 4r^2))/8 for |r| <= 1,  (5 - 2|r| - sqrt(-7 + 12|r| - 4r^2))/8 for
//   |r| <= 2.
// Its even and odd sums over the grid are 1/2 and its first moment is 0, at any position.
#pragma once

#include <cmath>

namespace valsalva::ib3d {

/// Number of grid points that a node touches in each direction.
inline constexpr int kDeltaWidth = 4;

/// The square root in phi for a point at fraction r in [0, 1) above a lattice point.
inline double delta_root(double r)
{
  return std::sqrt(1 + 4 * r - 4 * r * r);
}

/// Weight m of the four is kDeltaBase[m] + kDeltaSlope[m] r + kDeltaRoot[m] delta_root(r).
inline constexpr double kDeltaBase[kDeltaWidth] = {0.375, 0.375, 0.125, 0.125};
inline constexpr double kDeltaSlope[kDeltaWidth] = {-0.25, -0.25, 0.25, 0.25};
inline constexpr double kDeltaRoot[kDeltaWidth] = {-0.125, 0.125, 0.125, -0.125};

/// The four weights on a lattice with unit spacing for a point at fraction r in [0, 1) above lattice point 0:
/// w[m] belongs to lattice point m - 1.
inline void delta_weights(double r, double w[kDeltaWidth])
{
  for (int m = 0; m < kDeltaWidth; ++m)
    w[m] = kDeltaBase[m] + kDeltaSlope[m] * r + kDeltaRoot[m] * delta_root(r);
}

}  // namespace valsalva::ib3d
