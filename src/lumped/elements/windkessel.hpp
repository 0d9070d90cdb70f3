// Windkessel of two, three or four elements: the arterial tree seen from its root.
//
//               +--[ L ]--+
//     node o->--+--[ Rc ]-+--o----[ Rp ]----o Pd     P = Pc + Rc (Q - QL)
//           Q                |                       C dPc/dt = Q - (Pc - Pd)/Rp
//                           === C  (pressure Pc)     L dQL/dt = Rc (Q - QL)     (windkessel4 only; else QL = 0)
//                            |
//   Rc_mmHg_s_ml   characteristic resistance, mmHg s/ml; 0 gives the two-element Windkessel
//   Rp_mmHg_s_ml   peripheral resistance, mmHg s/ml        C_ml_mmHg   compliance, ml/mmHg
//   L_mmHg_s2_ml   of windkessel4: total arterial inertance, beside Rc, mmHg s^2/ml
//   initial_pressure_mmHg   Pc at the start                distal_pressure_mmHg   Pd
//   pressurise_s   while t < pressurise_s the node's pressure is prescribed, initial_pressure t/pressurise_s,
//                  and Pc is held: a 3D root at rest is filled gently. At pressurise_s the node's pressure
//                  becomes free.
// States: Pc (mmHg), QL (ml/s). Source: Westerhof, Lankhaar & Westerhof, Med Biol Eng Comput 47 (2009)
// 131-141; fourth element and the human type-A beat: Stergiopulos, Westerhof & Westerhof, Am J Physiol 276
// (1999) H81-H88.
#pragma once

#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class Windkessel final : public Element<Scalar> {
 public:
  explicit Windkessel(const ElementInput<Scalar>& input);

  NodeRole role(int) const override;
  std::vector<StateVariable<Scalar>> states() const override;
  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  void rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
             Scalar* dydt) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Scalar energy(LocalState<Scalar> state) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  Scalar next_kink(double t) const override;
  Scalar volume(LocalState<Scalar> state) const override { return C_ * state.y[0]; }
  bool keeps_volume() const override { return false; }

 private:
  using Element<Scalar>::node;
  bool pressurises(Instant now) const { return now.piece < pressurise_s_; }
  /// The pressure behind Rc.
  Scalar pressure_behind(LocalState<Scalar> state) const
  {
    return has_inertance_ ? state.y[0] - Rc_ * state.y[1] : state.y[0];
  }

  Scalar Rc_, Rp_, C_, initial_pressure_, distal_pressure_, pressurise_s_;
  bool has_inertance_;
  Scalar L_;
};

ElementType windkessel3_type();
ElementType windkessel4_type();

}  // namespace valsalva::lumped
