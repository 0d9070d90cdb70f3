// How far two sets of nodes are from each other.
#pragma once

#include <limits>
#include <vector>

#include "common/max_or_nan.hpp"
#include "common/vec3.hpp"

namespace valsalva {

/// The largest distance between nodes of the same number: infinite for sets of different size, NaN if a
/// coordinate is.
inline double furthest_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double furthest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) furthest = max_or_nan(furthest, norm(a[n] - b[n]));
  return furthest;
}

}  // namespace valsalva
