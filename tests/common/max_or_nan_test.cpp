#include "common/max_or_nan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace valsalva::common {

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(MaxOrNan, ANanOnEitherSideIsTheResult)
{
  EXPECT_TRUE(std::isnan(max_or_nan(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(max_or_nan(1.0, kNaN)));
  EXPECT_TRUE(std::isnan(min_or_nan(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(min_or_nan(1.0, kNaN)));
}

TEST(MaxOrNan, OfNumbersItIsTheMaximum)
{
  EXPECT_EQ(max_or_nan(-2.0, -3.0), -2.0);
  EXPECT_EQ(max_or_nan(2.0, INFINITY), INFINITY);
  EXPECT_EQ(min_or_nan(-2.0, -3.0), -3.0);
}

TEST(MaxOrNan, ARangeWithANanAnywhereHasNoMaximum)
{
  for (std::size_t at = 0; at < 3; ++at) {
    std::vector<double> values{3.0, -5.0, 4.0};
    EXPECT_EQ(max_or_nan(values, [](double x) { return std::abs(x); }), 5.0);
    values[at] = kNaN;
    EXPECT_TRUE(std::isnan(max_or_nan(values)));
  }
}

}  // namespace

}  // namespace valsalva::common
