#include "lumped/activation.hpp"

#include <cmath>
#include <numbers>

namespace valsalva::lumped {

Activation Activation::double_hill(DoubleHill shape, double period_s)
{
  Activation a;
  a.shape_ = shape;
  a.log_tau1_ = std::log(shape.tau1_s);
  a.log_tau2_ = std::log(shape.tau2_s);
  // Golden-section search: e has one maximum, rising before it and falling after it.
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0, high = period_s;
  while (high - low > 1e-9 * period_s) {
    const double t1 = high - ratio * (high - low), t2 = low + ratio * (high - low);
    if (a.value(t1) < a.value(t2))
      low = t1;
    else
      high = t2;
  }
  a.k_ = 1.0 / a.value(0.5 * (low + high));
  return a;
}

Activation Activation::half_cosine(double systole_s)
{
  Activation a;
  a.is_half_cosine_ = true;
  a.systole_s_ = systole_s;
  return a;
}

double Activation::value(double t) const
{
  if (is_half_cosine_)
    return t < systole_s_ ? 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * t / systole_s_)) : 0.0;
  if (t <= 0.0) return 0.0;
  const double log_t = std::log(t);
  const double h1 = std::exp(shape_.n1 * (log_t - log_tau1_));
  const double h2 = std::exp(shape_.n2 * (log_t - log_tau2_));
  return k_ * h1 / (1.0 + h1) / (1.0 + h2);
}

}  // namespace valsalva::lumped
