#include "lumped/integration/short_vector.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace valsalva::lumped {

namespace {

/// The operations on vectors of kCount entries, which the compiler then writes out without a loop; of any number
/// of entries for kCount = 0. Arguments may be one and the same vector: all works entry by entry.
template <sunindextype kCount>
struct Arithmetic {
  static sunindextype count(N_Vector v) { return kCount > 0 ? kCount : NV_LENGTH_S(v); }

  static void linear_sum(double a, N_Vector x_vector, double b, N_Vector y_vector, N_Vector z_vector)
  {
    const double *x = NV_DATA_S(x_vector), *y = NV_DATA_S(y_vector);
    double* z = NV_DATA_S(z_vector);
#pragma omp simd
    for (sunindextype i = 0; i < count(x_vector); ++i) z[i] = a * x[i] + b * y[i];
  }

  static void scale(double factor, N_Vector x_vector, N_Vector z_vector)
  {
    const double* x = NV_DATA_S(x_vector);
    double* z = NV_DATA_S(z_vector);
#pragma omp simd
    for (sunindextype i = 0; i < count(x_vector); ++i) z[i] = factor * x[i];
  }

  /// z_k = a_k x + y_k
  static int scale_and_add(int terms, double* a, N_Vector x, N_Vector* y, N_Vector* z)
  {
    for (int k = 0; k < terms; ++k) linear_sum(a[k], x, 1.0, y[k], z[k]);
    return 0;
  }

  /// z_k = a_k x_k
  static int scale_each(int terms, double* a, N_Vector* x, N_Vector* z)
  {
    for (int k = 0; k < terms; ++k) scale(a[k], x[k], z[k]);
    return 0;
  }

  static void fill(double value, N_Vector z_vector)
  {
    double* z = NV_DATA_S(z_vector);
#pragma omp simd
    for (sunindextype i = 0; i < count(z_vector); ++i) z[i] = value;
  }

  static void absolute(N_Vector x_vector, N_Vector z_vector)
  {
    const double* x = NV_DATA_S(x_vector);
    double* z = NV_DATA_S(z_vector);
#pragma omp simd
    for (sunindextype i = 0; i < count(x_vector); ++i) z[i] = std::abs(x[i]);
  }

  static void invert(N_Vector x_vector, N_Vector z_vector)
  {
    const double* x = NV_DATA_S(x_vector);
    double* z = NV_DATA_S(z_vector);
#pragma omp simd
    for (sunindextype i = 0; i < count(x_vector); ++i) z[i] = 1.0 / x[i];
  }

  static double weighted_rms(N_Vector x_vector, N_Vector weights)
  {
    const double *x = NV_DATA_S(x_vector), *w = NV_DATA_S(weights);
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (sunindextype i = 0; i < count(x_vector); ++i) sum += (x[i] * w[i]) * (x[i] * w[i]);
    return std::sqrt(sum / static_cast<double>(count(x_vector)));
  }

  static void put_into(N_Vector vector)
  {
    N_Vector_Ops ops = vector->ops;
    ops->nvlinearsum = linear_sum;
    ops->nvscale = scale;
    ops->nvscaleaddmulti = scale_and_add;
    ops->nvscalevectorarray = scale_each;
    ops->nvconst = fill;
    ops->nvabs = absolute;
    ops->nvinv = invert;
    ops->nvwrmsnorm = weighted_rms;
  }
};

constexpr std::size_t kLongestWrittenOut = 24;

template <std::size_t... kCounts>
constexpr auto setters(std::index_sequence<kCounts...>)
{
  return std::array{&Arithmetic<static_cast<sunindextype>(kCounts)>::put_into...};
}
constexpr auto kPutInto = setters(std::make_index_sequence<kLongestWrittenOut + 1>());

}  // namespace

N_Vector new_short_vector(sunindextype count, SUNContext context)
{
  N_Vector vector = N_VNew_Serial(count, context);
  if (!vector) return nullptr;
  const auto entries = static_cast<std::size_t>(count);
  kPutInto[entries <= kLongestWrittenOut ? entries : 0](vector);
  return vector;
}

}  // namespace valsalva::lumped
