// The larger or smaller of two numbers, and the largest of a range, where one may be NaN: then the result is NaN.
//     std::max(0.0, NaN) = 0     max_or_nan(0.0, NaN) = NaN
// so that an error, a residual or a norm that is not a number fails the comparison it is made for. Of Eigen's
// arrays, maxCoeff<Eigen::PropagateNaN>() does the same; over ranks, Communicator::max and min.
#pragma once

#include <functional>
#include <limits>
#include <ranges>

namespace valsalva::common {

constexpr double max_or_nan(double a, double b)
{
  return a >= b || a != a ? a : b;
}

constexpr double min_or_nan(double a, double b)
{
  return a <= b || a != a ? a : b;
}

/// The largest `measure(x)` of a range; minus infinity of an empty one.
template <std::ranges::input_range Range, class Measure = std::identity>
constexpr double max_or_nan(const Range& range, Measure measure = {})
{
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& x : range) largest = max_or_nan(largest, measure(x));
  return largest;
}

}  // namespace valsalva::common

namespace valsalva {
using common::max_or_nan;
using common::min_or_nan;
}  // namespace valsalva
