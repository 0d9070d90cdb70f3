// The two upwind values along a line, from means over intervals.
#include "ib3d/fluid/upwind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace valsalva::ib3d {
namespace {

using Upwind = double (*)(const double*, std::ptrdiff_t, bool);
constexpr std::array<Upwind, 2> kBoth{limited_upwind, xsppm7_upwind};

/// Means over [x + m h, x + (m + 1) h], m = -4 ... 3, of the derivative of F: the side lies at x.
template <class F>
std::array<double, 8> means(F&& integral, double x, double h)
{
  std::array<double, 8> q{};
  for (int m = 0; m < 8; ++m)
    q[static_cast<std::size_t>(m)] = (integral(x + (m - 3) * h) - integral(x + (m - 4) * h)) / h;
  return q;
}

TEST(Upwind, AUniformValueIsKeptExactly)
{
  const std::array<double, 8> q{0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3};
  for (const Upwind upwind : kBoth)
    for (const bool forward : {true, false}) EXPECT_EQ(upwind(q.data() + 4, 1, forward), 0.3);
}

TEST(Upwind, BothDirectionsMirrorEachOther)
{
  const std::array<double, 8> q{0.1, 0.7, -0.4, 0.9, 1.3, 0.2, 0.5, -0.8};
  std::array<double, 8> r{};
  std::reverse_copy(q.begin(), q.end(), r.begin());
  for (const Upwind upwind : kBoth) EXPECT_EQ(upwind(q.data() + 4, 1, true), upwind(r.data() + 4, 1, false));
}

TEST(Upwind, XsPpm7IsSeventhOrderOnMonotoneData)
{
  const auto error = [](double h) {
    const auto q = means([](double x) { return std::exp(x); }, 0.4, h);
    return std::abs(xsppm7_upwind(q.data() + 4, 1, true) - std::exp(0.4));
  };
  EXPECT_NEAR(std::log2(error(0.2) / error(0.1)), 7, 0.3);
}

TEST(Upwind, XsPpm7IsThirdOrderAtASmoothExtremumWhereTheLimitedValueIsOnlySecond)
{
  const auto order = [](Upwind upwind) {
    const auto error = [&](double h) {
      // The interval upwind of the side has the extremum of cos at its middle.
      const auto q = means([](double x) { return std::sin(x); }, 0.5 * h, h);
      return std::abs(upwind(q.data() + 4, 1, true) - std::cos(0.5 * h));
    };
    return std::log2(error(0.2) / error(0.1));
  };
  EXPECT_NEAR(order(limited_upwind), 2, 0.1);
  EXPECT_GT(order(xsppm7_upwind), 3);
}

TEST(Upwind, NoValueLeavesItsNeighboursAtAJump)
{
  for (int jump = 0; jump <= 8; ++jump)
    for (const Upwind upwind : kBoth)
      for (const bool forward : {true, false}) {
        std::array<double, 8> q{};
        std::fill(q.begin() + jump, q.end(), 1.0);
        const double value = upwind(q.data() + 4, 1, forward);
        EXPECT_GE(value, std::min(q[3], q[4]) - 1e-9) << jump;
        EXPECT_LE(value, std::max(q[3], q[4]) + 1e-9) << jump;
      }
}

}  // namespace
}  // namespace valsalva::ib3d
