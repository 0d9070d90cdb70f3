// The innermost loops of the fluid solver, along rows of n contiguous values. Scalars come by value and outputs are
// __restrict: a loop inside a lambda that captures its scalars by reference does not vectorise.
// sy, sz: strides (in values) to the neighbours along y and z.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace valsalva::ib3d {

/// Sum of the six neighbours of c[i].
template <class T>
inline T neighbours(const T* c, std::ptrdiff_t i, std::ptrdiff_t sy, std::ptrdiff_t sz)
{
  return (c[i - 1] + c[i + 1]) + (c[i - sy] + c[i + sy]) + (c[i - sz] + c[i + sz]);
}

/// Factors of momentum_row.
struct MomentumWeights {
  double convection, diffusion;  ///< of h div(u u) and h^2 lap u in the rate G
  double now, before;            ///< of the rates in u*
  double apart;                  ///< of h^2 lap u in u*, beside its part in G
};

/// g = G = convection div + diffusion L,  L = neighbours - 6 q;  out = q + now G + before g_before + apart L.
inline void momentum_row(double* __restrict out, double* __restrict g, const double* __restrict g_before,
                         const double* __restrict q, const double* __restrict div, MomentumWeights w,
                         std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  for (int i = 0; i < n; ++i) {
    const double laplacian = neighbours(q, i, sy, sz) - 6 * q[i];
    const double rate = w.convection * div[i] + w.diffusion * laplacian;
    out[i] = q[i] + w.now * rate + w.before * g_before[i] + w.apart * laplacian;
    g[i] = rate;
  }
}

/// The same with a rate g that is kept.
inline void kept_momentum_row(double* __restrict out, const double* __restrict g,
                              const double* __restrict g_before, const double* __restrict q,
                              MomentumWeights w, std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  if (w.apart == 0)
    for (int i = 0; i < n; ++i) out[i] = q[i] + w.now * g[i] + w.before * g_before[i];
  else
    for (int i = 0; i < n; ++i)
      out[i] = q[i] + w.now * g[i] + w.before * g_before[i] + w.apart * (neighbours(q, i, sy, sz) - 6 * q[i]);
}

/// out = (b + a neighbours)/(1 + 6 a): one Jacobi sweep for (1 + 6 a) q - a neighbours = b.
inline void jacobi_row(double* __restrict out, const double* __restrict b, const double* __restrict q,
                       double a, std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  const double scale = 1 / (1 + 6 * a);
  for (int i = 0; i < n; ++i) out[i] = scale * (b[i] + a * neighbours(q, i, sy, sz));
}

/// The largest of some non-negative numbers, or infinity where their sum says that one is NaN, which a maximum passes over.
template <class T>
inline T largest_or_infinity(T largest, T sum)
{
  return std::isnan(sum) ? std::numeric_limits<T>::infinity() : largest;
}

/// largest = max of itself and |a - b|, |b|; infinity for NaN.
inline void compare_row(const double* a, const double* b, double (&largest)[2], int n)
{
  double change = largest[0], value = largest[1], sum = 0;
#pragma omp simd reduction(max : change, value) reduction(+ : sum)
  for (int i = 0; i < n; ++i) {
    change = std::max(change, std::abs(a[i] - b[i]));
    value = std::max(value, std::abs(b[i]));
    sum += std::abs(a[i] - b[i]);
  }
  largest[0] = largest_or_infinity(change, sum);
  largest[1] = value;
}

/// out += a x.
inline void add_row(double* __restrict out, const double* __restrict x, double a, int n)
{
  for (int i = 0; i < n; ++i) out[i] += a * x[i];
}

/// guess = p + ratio (p - before).
inline void extrapolate_row(double* __restrict guess, const double* __restrict p,
                            const double* __restrict before, double ratio, std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i) guess[i] = p[i] + ratio * (p[i] - before[i]);
}

/// r = neighbours - 6 c - source (x[i+1] - x[i] + y[i+fy] - y[i] + z[i+fz] - z[i]), for faces with strides fy, fz.
inline void pressure_residual_row(float* __restrict r, const double* __restrict c, const double* __restrict x,
                                  const double* __restrict y, const double* __restrict z, double source,
                                  std::ptrdiff_t sy, std::ptrdiff_t sz, std::ptrdiff_t fy, std::ptrdiff_t fz,
                                  int n)
{
  for (int i = 0; i < n; ++i) {
    const double div = (x[i + 1] - x[i]) + (y[i + fy] - y[i]) + (z[i + fz] - z[i]);
    r[i] = static_cast<float>((neighbours(c, i, sy, sz) - 6 * c[i]) - source * div);
  }
}

/// r = neighbours - 6 c.
inline void laplacian_row(float* __restrict r, const double* __restrict c, std::ptrdiff_t sy,
                          std::ptrdiff_t sz, int n)
{
  for (int i = 0; i < n; ++i) r[i] = static_cast<float>(neighbours(c, i, sy, sz) - 6 * c[i]);
}

/// u -= factor (p[i] - p[i - s]).
inline void correct_row(double* __restrict u, const double* __restrict p, double factor, std::ptrdiff_t s,
                        int n)
{
  for (int i = 0; i < n; ++i) u[i] -= factor * (p[i] - p[i - s]);
}

/// d = z + b d.
inline void direction_row(float* __restrict d, const float* __restrict z, float b, int n)
{
  for (int i = 0; i < n; ++i) d[i] = z[i] + b * d[i];
}

struct TwoSums {
  double first = 0, second = 0;
  TwoSums& operator+=(const TwoSums& s)
  {
    first += s.first;
    second += s.second;
    return *this;
  }
};

/// Sums of z r and z y. Rows are short: within one, single precision does.
inline TwoSums two_products_row(const float* z, const float* r, const float* y, int n)
{
  float zr = 0, zy = 0;
#pragma omp simd reduction(+ : zr, zy)
  for (int i = 0; i < n; ++i) {
    zr += z[i] * r[i];
    zy += z[i] * y[i];
  }
  return {zr, zy};
}

/// y = 6 d - neighbours; sums of d y and d r.
inline TwoSums apply_row(float* __restrict y, const float* __restrict d, const float* __restrict r,
                         std::ptrdiff_t sy, std::ptrdiff_t sz, int n)
{
  float dy = 0, dr = 0;
#pragma omp simd reduction(+ : dy, dr)
  for (int i = 0; i < n; ++i) {
    const float a = 6 * d[i] - neighbours(d, i, sy, sz);
    y[i] = a;
    dy += d[i] * a;
    dr += d[i] * r[i];
  }
  return {dy, dr};
}

/// x += alpha d, r -= alpha y; returns the sum of r^2.
inline double update_row(double* __restrict x, float* __restrict r, const float* __restrict d,
                         const float* __restrict y, float alpha, int n)
{
  float square = 0;
#pragma omp simd reduction(+ : square)
  for (int i = 0; i < n; ++i) {
    x[i] += static_cast<double>(alpha * d[i]);
    r[i] -= alpha * y[i];
    square += r[i] * r[i];
  }
  return square;
}

/// max |r|; infinity for NaN.
inline float largest_in_row(const float* r, int n)
{
  float largest = 0, sum = 0;
#pragma omp simd reduction(max : largest) reduction(+ : sum)
  for (int i = 0; i < n; ++i) {
    largest = std::max(largest, std::abs(r[i]));
    sum += std::abs(r[i]);
  }
  return largest_or_infinity(largest, sum);
}

}  // namespace valsalva::ib3d
