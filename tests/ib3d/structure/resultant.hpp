// What nodal vectors V at X amount to as a whole: sum of V and sum of X x V, zero for everything that elastic elements
// do among themselves.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "common/vec3.hpp"

namespace valsalva::ib3d {

/// Both sums vanish to rounding beside the sum of |V|, which is not small itself.
inline void expect_no_resultant(const std::vector<Vec3>& X, const std::vector<Vec3>& V)
{
  Vec3 sum{0.0, 0.0, 0.0}, moment{0.0, 0.0, 0.0};
  double size = 0.0;
  for (std::size_t n = 0; n < V.size(); ++n) {
    sum += V[n];
    moment += cross(X[n], V[n]);
    size += norm(V[n]);
  }
  ASSERT_GT(size, 1.0);
  EXPECT_LT(norm(sum), 1e-12 * size);
  EXPECT_LT(norm(moment), 1e-12 * size);
}

}  // namespace valsalva::ib3d
