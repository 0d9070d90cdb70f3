// Heart chamber with a time-varying elastance.
//
//     node o--->--[ R ]----o                         P = E(t) (V - V0) + R Q
//           Q              |                         dV/dt = Q
//                        ( V )                       E = Emin + (Emax - Emin) e(t),  periodic in T
//
//   Emax_mmHg_ml, Emin_mmHg_ml  (mmHg/ml)    V0_ml  volume at zero pressure    initial_volume_ml  V at t = 0
//   period_s  T, default the case's          R_mmHg_s_ml  source resistance, default 0
//   activation  "double_hill" with n1, n2, tau1_periods, tau2_periods, or "half_cosine" with systole_periods;
//               times as fractions of T; see activation.hpp
//   onset_periods  contraction sets in at onset_periods T, and again after each T; default 0
// State: V (ml). Source: Suga & Sagawa, Circ Res 35 (1974) 117-126.
#pragma once

#include "lumped/elements/activation.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class Chamber final : public Element<Scalar> {
 public:
  explicit Chamber(const ElementInput<Scalar>& input);

  NodeRole role(int) const override { return R_ > 0.0 ? NodeRole::determines : NodeRole::fixes; }
  std::vector<StateVariable<Scalar>> states() const override;
  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  void rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
             Scalar* dydt) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  Scalar next_kink(double t) const override;
  Scalar volume(LocalState<Scalar> state) const override { return state.y[0]; }

 private:
  using Element<Scalar>::node;
  /// The contraction under way at `piece` began here.
  Scalar onset(double piece) const;
  Scalar elastic_pressure(Instant now, const Scalar& V) const;
  /// E(t), mmHg/ml.
  const Scalar& elastance(Instant now) const;

  Scalar Emax_, Emin_, V0_, initial_volume_, R_, period_s_, onset_s_;
  Activation<Scalar> activation_;

  /// The last answer of `elastance`: CVODE evaluates its equations several times at one instant.
  struct Known {
    Instant at;
    Scalar E;
  };
  mutable Known known_{{-1.0, std::numeric_limits<double>::quiet_NaN()}, 0.0};
};

ElementType chamber_type();

}  // namespace valsalva::lumped
