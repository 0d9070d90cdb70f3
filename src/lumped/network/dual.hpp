// A number with its derivatives along kLanes directions: exact forward-mode differentiation. Every element of
// the network computes with a scalar that is either `double` or `Dual`, so that the same formulas give values
// and tangents:
//     f(a + eps a') = f(a) + eps f'(a) a'
// Comparisons look at the value alone. Source: Griewank & Walther, Evaluating Derivatives, SIAM 2008,
// chapter 3.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace valsalva::lumped {

/// Directions that one evaluation carries: one register of eight doubles, or two of four.
inline constexpr int kLanes = 8;

struct Dual {
  using Tangent = Eigen::Array<double, kLanes, 1>;
  double value = 0.0;
  Tangent tangent = Tangent::Zero();

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants take part in formulas
  Dual(double v, const Tangent& t) : value(v), tangent(t) {}

  Dual& operator+=(const Dual& b)
  {
    value += b.value;
    tangent += b.tangent;
    return *this;
  }
  Dual& operator-=(const Dual& b)
  {
    value -= b.value;
    tangent -= b.tangent;
    return *this;
  }
  Dual& operator*=(const Dual& b)
  {
    tangent = tangent * b.value + value * b.tangent;
    value *= b.value;
    return *this;
  }
  Dual& operator/=(const Dual& b)
  {
    value /= b.value;
    tangent = (tangent - value * b.tangent) / b.value;
    return *this;
  }

  friend Dual operator-(const Dual& a) { return {-a.value, -a.tangent}; }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
  friend Dual operator/(Dual a, const Dual& b) { return a /= b; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
};

inline Dual abs(const Dual& a)
{
  return a.value < 0.0 ? -a : a;
}
inline Dual sqrt(const Dual& a)
{
  const double root = std::sqrt(a.value);
  return {root, 0.5 / root * a.tangent};
}
inline Dual exp(const Dual& a)
{
  const double e = std::exp(a.value);
  return {e, e * a.tangent};
}
inline Dual log(const Dual& a)
{
  return {std::log(a.value), a.tangent / a.value};
}
inline Dual cos(const Dual& a)
{
  return {std::cos(a.value), -std::sin(a.value) * a.tangent};
}

/// The value without its tangent.
inline double value_of(double a)
{
  return a;
}
inline double value_of(const Dual& a)
{
  return a.value;
}

}  // namespace valsalva::lumped
