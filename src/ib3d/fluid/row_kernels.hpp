// The innermost loops of the fluid solver, along rows of n contiguous values. Scalars come by value and outputs are
// __restrict: a loop inside a lambda that captures its scalars by reference does not vectorise.
// sy, sz: strides (in values) to the neighbours along y and z.
#pragma once

#include <cstddef>

namespace valsalva::ib3d {

/// Sum of the six neighbours of c[i].
template <class T>
inline T neighbours(const T* c, std::ptrdiff_t i, std::ptrdiff_t sy, std::ptrdiff_t sz)
{
  return (c[i - 1] + c[i + 1]) + (c[i - sy] + c[i + sy]) + (c[i - sz] + c[i + sz]);
}

/// out = q + now G + before g + force f,  G = convection div + diffusion (neighbours - 6 q); then g = G.
inline void momentum_row(double* __restrict out, double* __restrict g, const double* __restrict q,
                         const double* __restrict div, const double* __restrict f, double convection,
                         double diffusion, double now, double before, double force, std::ptrdiff_t sy,
                         std::ptrdiff_t sz, int n)
{
  for (int i = 0; i < n; ++i) {
    const double rate = convection * div[i] + diffusion * (neighbours(q, i, sy, sz) - 6 * q[i]);
    out[i] = q[i] + now * rate + before * g[i] + force * f[i];
    g[i] = rate;
  }
}

/// r = lap (neighbours - 6 c) - source (x[i+1] - x[i] + y[i+sy] - y[i] + z[i+sz] - z[i]), for faces with strides fy, fz.
inline void pressure_residual_row(double* __restrict r, const double* __restrict c,
                                  const double* __restrict x, const double* __restrict y,
                                  const double* __restrict z, double lap, double source, std::ptrdiff_t sy,
                                  std::ptrdiff_t sz, std::ptrdiff_t fy, std::ptrdiff_t fz, int n)
{
  for (int i = 0; i < n; ++i) {
    const double div = (x[i + 1] - x[i]) + (y[i + fy] - y[i]) + (z[i + fz] - z[i]);
    r[i] = lap * (neighbours(c, i, sy, sz) - 6 * c[i]) - source * div;
  }
}

/// u -= factor (p[i] - p[i - s]).
inline void correct_row(double* __restrict u, const double* __restrict p, double factor, std::ptrdiff_t s,
                        int n)
{
  for (int i = 0; i < n; ++i) u[i] -= factor * (p[i] - p[i - s]);
}

/// to = a from.
template <class To, class From>
inline void scale_row(To* __restrict to, const From* __restrict from, double a, int n)
{
  for (int i = 0; i < n; ++i) to[i] = static_cast<To>(a * from[i]);
}

/// d = a z + b d.
inline void direction_row(float* __restrict d, const float* __restrict z, double a, double b, int n)
{
  for (int i = 0; i < n; ++i) d[i] = static_cast<float>(a * z[i] + b * d[i]);
}

struct TwoSums {
  double first = 0, second = 0;
};

/// Sums of z r and z y.
inline TwoSums two_products_row(const float* z, const double* r, const double* y, int n)
{
  double zr = 0, zy = 0;
#pragma omp simd reduction(+ : zr, zy)
  for (int i = 0; i < n; ++i) {
    zr += z[i] * r[i];
    zy += z[i] * y[i];
  }
  return {zr, zy};
}

/// ad = scale (6 d - neighbours); sums of d ad and d r.
inline TwoSums apply_row(double* __restrict ad, const float* __restrict d, const double* __restrict r,
                         double scale, std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  double dad = 0, dr = 0;
#pragma omp simd reduction(+ : dad, dr)
  for (int i = 0; i < n; ++i) {
    const double c = d[i];
    const double sum =
        (double{d[i - 1]} + d[i + 1]) + (double{d[i - sy]} + d[i + sy]) + (double{d[i - sz]} + d[i + sz]);
    const double y = scale * (6 * c - sum);
    ad[i] = y;
    dad += c * y;
    dr += c * r[i];
  }
  return {dad, dr};
}

/// x += alpha d, r -= alpha ad; returns the sum of r^2.
inline double update_row(double* __restrict x, double* __restrict r, const float* __restrict d,
                         const double* __restrict ad, double alpha, int n)
{
  double square = 0;
#pragma omp simd reduction(+ : square)
  for (int i = 0; i < n; ++i) {
    x[i] += alpha * d[i];
    r[i] -= alpha * ad[i];
    square += r[i] * r[i];
  }
  return square;
}

}  // namespace valsalva::ib3d
