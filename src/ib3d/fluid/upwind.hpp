// Value of a transported quantity q on the side between its places 0 and 1 (stride s apart), from the upwind side.
// In the upwind order q_0 is the last value before the side, q_1 the first one behind it.
//   limited  q_0 + s/2, s = (a + 2 b)/3 of the upwind difference a and the downwind one b, limited to
//            |s| <= 2 min(|a|, |b|) and to 0 at extrema: third order where smooth (Koren 1993)
//   xsppm7   the median of three values: the one of the polynomial of degree 6 through the means q_-3 ... q_3; the same
//            limited as in the piecewise parabolic method (Colella & Woodward 1984), which is q_0 at an extremum; and
//            the fifth-order WENO value (Jiang & Shu 1996), which tells smooth extrema from others (Rider, Greenough &
//            Kamm 2007, without their second limiting from fourth-order values)
// Both give q_0 exactly where q is uniform, and have neither branches nor state: rows of them vectorise.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace valsalva::ib3d {

/// The convective flux; none is Stokes flow.
enum class Advection { none, limited, xsppm7 };

/// Ghost layers that the flux and the viscous term read.
constexpr int ghosts_read(Advection a)
{
  return a == Advection::xsppm7 ? 4 : 2;
}

inline double median(double a, double b, double c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// q: the value above the side; forward: whether the flow goes from q[-s] to q[0].
inline double limited_upwind(const double* q, std::ptrdiff_t s, bool forward)
{
  const double below2 = q[-2 * s], below = q[-s], above = q[0], above2 = q[s];
  const double q0 = forward ? below : above;
  const double a = forward ? below - below2 : above - above2;
  const double b = forward ? above - below : below - above;
  const double bound = 2 * std::min(std::abs(a), std::abs(b));
  const double slope = (a + 2 * b) * (1.0 / 3.0);
  const double limited = std::max(-bound, std::min(bound, slope));
  return q0 + 0.5 * (a * b > 0 ? limited : 0.0);
}

/// Fifth-order WENO value less q_0, from the differences a = q_-1 - q_-2, ..., d = q_2 - q_1.
inline double weno5(double a, double b, double c, double d)
{
  constexpr double kSmooth = 1e-12;  // (cm/s)^2: below it differences are rounding
  const auto square = [](double x) { return x * x; };
  const double r0 = kSmooth + 13.0 / 3.0 * square(b - a) + square(3 * b - a);
  const double r1 = kSmooth + 13.0 / 3.0 * square(c - b) + square(c + b);
  const double r2 = kSmooth + 13.0 / 3.0 * square(d - c) + square(d - 3 * c);
  // The weights 0.1/r0^2, 0.6/r1^2, 0.3/r2^2, without their common denominator.
  const double w0 = square(r1 * r2), w1 = 6 * square(r0 * r2), w2 = 3 * square(r0 * r1);
  return (w0 * (5 * b - 2 * a) + w1 * (2 * c + b) + w2 * (4 * c - d)) / (6 * (w0 + w1 + w2));
}

/// As limited_upwind.
inline double xsppm7_upwind(const double* q, std::ptrdiff_t s, bool forward)
{
  const double l3 = q[-4 * s], l2 = q[-3 * s], l1 = q[-2 * s], l0 = q[-s];
  const double h0 = q[0], h1 = q[s], h2 = q[2 * s], h3 = q[3 * s];
  const double q0 = forward ? l0 : h0, down1 = forward ? h0 : l0, down2 = forward ? h1 : l1;
  const double down3 = forward ? h2 : l2, up1 = forward ? l1 : h1, up2 = forward ? l2 : h2;
  const double up3 = forward ? l3 : h3;
  // Differences in the upwind order; all values from here on are less q_0.
  const double a = up2 - up3, b = up1 - up2, c = q0 - up1, d = down1 - q0, e = down2 - down1,
               f = down3 - down2;
  const double behind = (1.0 / 420.0) * (4 * f - 34 * e + 180 * d + 79 * c - 22 * b + 3 * a);
  const double before = (-1.0 / 420.0) * (4 * a - 34 * b + 180 * c + 79 * d - 22 * e + 3 * f);
  const double between = median(0, before, -c);
  const double monotone = median(0, median(0, behind, d), -2 * between);
  return q0 + median(monotone, behind, weno5(b, c, d, e));
}

}  // namespace valsalva::ib3d
