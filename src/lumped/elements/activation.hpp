// How far a heart chamber is contracted, e(t) from 0 (relaxed) to 1, over one heart period T.
//   double Hill   e = k h1/(1 + h1) 1/(1 + h2),  h_i = (t/tau_i)^{n_i},  k so that the maximum is 1
//   half cosine   e = (1 - cos(2 pi t/Ts))/2 for t < Ts, then 0
// Times in s from the onset of contraction. Source: double Hill, Stergiopulos, Meister & Westerhof, Am J
// Physiol 270 (1996) H2050-H2059, with the constants of Mynard et al. 2012 rescaled to T.
#pragma once

#include "lumped/network/dual.hpp"

namespace valsalva::lumped {

template <class Scalar>
struct DoubleHill {
  Scalar n1, n2, tau1_s, tau2_s;
};

template <class Scalar>
class Activation {
 public:
  /// Scaled so that its maximum over the period is 1.
  static Activation double_hill(DoubleHill<Scalar> shape, const Scalar& period_s);
  /// `systole_s` > 0: the time Ts of the contraction.
  static Activation half_cosine(const Scalar& systole_s);

  /// e at `t` seconds after the onset, 0 <= t <= T.
  Scalar value(const Scalar& t) const;
  /// Where, within a period, the formula changes; 0 if only at its beginning.
  Scalar kink() const { return is_half_cosine_ ? systole_s_ : Scalar(0.0); }

 private:
  Activation() = default;
  bool is_half_cosine_ = false;
  Scalar systole_s_ = 0.0;
  DoubleHill<Scalar> shape_{};
  Scalar log_tau1_ = 0.0, log_tau2_ = 0.0;
  Scalar k_ = 1.0;
};

}  // namespace valsalva::lumped
