// Heart valve as a diode with resistance R, inertance L and Bernoulli (jet) loss B.
//
//     from o--->--|>|--[ R ]--[ L ]--[ B ]--o to        open:   L dQ/dt = dp - R Q - B Q|Q|
//           Q                                           closed: Q = 0          dp = P_from - P_to
//
//   R_mmHg_s_ml  (mmHg s/ml)     L_mmHg_s2_ml  (mmHg s^2/ml, default 0)
//   B_mmHg_s2_ml2  (mmHg s^2/ml^2, default 0)
// It opens when dp crosses 0 upward and closes when Q crosses 0 downward. Without L the flow follows dp at
// once, R Q + B Q|Q| = dp. Both thresholds lie slightly (1e-10 mmHg, ml/s) beyond zero: to switch back, the
// valve has to cross that band, so that a grazing dp cannot make it chatter. Starts closed. State: Q (ml/s),
// only with L > 0. Source: Bernoulli term and inertance as in Mynard et al., Int J Numer Meth Biomed Engng 28
// (2012) 626-641, without the leaflets' motion (orifice_valve.hpp has it).
#pragma once

#include "lumped/network/branch.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class Valve final : public Element<Scalar> {
 public:
  explicit Valve(const ElementInput<Scalar>& input);

  std::vector<StateVariable<Scalar>> states() const override;
  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  void rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
             Scalar* dydt) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Scalar energy(LocalState<Scalar> state) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  bool switches() const override { return true; }
  Scalar switch_margin(LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  void on_switch(bool open, Scalar* y) const override;

 private:
  using Element<Scalar>::node;
  using Element<Scalar>::pressure_drop;

  Branch<Scalar> branch_;
};

ElementType valve_type();

}  // namespace valsalva::lumped
