// Three numbers: a point, a velocity or a force in Cartesian coordinates (x, y, z).
#pragma once

#include <array>
#include <cmath>

namespace valsalva::common {

using Int3 = std::array<int, 3>;

struct Vec3 {
  double c[3];
  double& operator[](int d) { return c[d]; }
  double operator[](int d) const { return c[d]; }
  bool operator==(const Vec3&) const = default;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double s, const Vec3& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}
inline Vec3& operator+=(Vec3& a, const Vec3& b)
{
  return a = a + b;
}
inline Vec3& operator-=(Vec3& a, const Vec3& b)
{
  return a = a - b;
}
inline double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}

inline Vec3 cross(const Vec3& a, const Vec3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace valsalva::common

namespace valsalva {
using common::Int3;
using common::Vec3;
}  // namespace valsalva
