// The six sides of the domain, and the directions across and along each.
#pragma once

#include <array>

namespace valsalva::ib3d {

enum class Side { x_lo, x_hi, y_lo, y_hi, z_lo, z_hi };
inline constexpr std::array<Side, 6> kSides{Side::x_lo, Side::x_hi, Side::y_lo,
                                            Side::y_hi, Side::z_lo, Side::z_hi};

/// The direction across the side: 0, 1, 2 for x, y, z.
constexpr int axis(Side s)
{
  return static_cast<int>(s) / 2;
}
constexpr bool is_high(Side s)
{
  return static_cast<int>(s) % 2 == 1;
}
/// Sign of the way into the domain along the axis.
constexpr int inward(Side s)
{
  return is_high(s) ? -1 : 1;
}
/// The directions along the side, in ascending order: rows along the first are closest in memory.
constexpr int first_tangent(Side s)
{
  return axis(s) == 0 ? 1 : 0;
}
constexpr int second_tangent(Side s)
{
  return axis(s) == 2 ? 1 : 2;
}

}  // namespace valsalva::ib3d
