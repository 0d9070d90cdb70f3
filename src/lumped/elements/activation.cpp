#include "lumped/elements/activation.hpp"

#include <cmath>
#include <numbers>

namespace valsalva::lumped {

template <class Scalar>
Activation<Scalar> Activation<Scalar>::double_hill(DoubleHill<Scalar> shape, const Scalar& period_s)
{
  using std::log;
  Activation<Scalar> a;
  a.shape_ = shape;
  a.log_tau1_ = log(shape.tau1_s);
  a.log_tau2_ = log(shape.tau2_s);
  // Golden-section search: e has one maximum, rising before it and falling after it. There its derivative
  // is zero, so that a shift of the place with the parameters does not change k.
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0, high = value_of(period_s);
  while (high - low > 1e-9 * value_of(period_s)) {
    const double t1 = high - ratio * (high - low), t2 = low + ratio * (high - low);
    if (a.value(Scalar(t1)) < a.value(Scalar(t2)))
      low = t1;
    else
      high = t2;
  }
  a.k_ = 1.0 / a.value(Scalar(0.5 * (low + high)));
  return a;
}

template <class Scalar>
Activation<Scalar> Activation<Scalar>::half_cosine(const Scalar& systole_s)
{
  Activation<Scalar> a;
  a.is_half_cosine_ = true;
  a.systole_s_ = systole_s;
  return a;
}

template <class Scalar>
Scalar Activation<Scalar>::value(const Scalar& t) const
{
  using std::cos, std::exp, std::log;
  if (is_half_cosine_)
    return t < systole_s_ ? 0.5 * (1.0 - cos(2.0 * std::numbers::pi * t / systole_s_)) : Scalar(0.0);
  if (t <= 0.0) return 0.0;
  const Scalar log_t = log(t);
  const Scalar h1 = exp(shape_.n1 * (log_t - log_tau1_));
  const Scalar h2 = exp(shape_.n2 * (log_t - log_tau2_));
  return k_ * h1 / (1.0 + h1) / (1.0 + h2);
}

template class Activation<double>;
template class Activation<Dual>;

}  // namespace valsalva::lumped
