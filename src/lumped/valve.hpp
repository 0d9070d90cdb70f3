// Heart valve as a diode with resistance R, inertance L and Bernoulli (jet) loss B.
//
//     from o--->--|>|--[ R ]--[ L ]--[ B ]--o to        open:   L dQ/dt = dp - R Q - B Q|Q|
//           Q                                           closed: Q = 0          dp = P_from - P_to
//
//   R_mmHg_s_ml  (mmHg s/ml)     L_mmHg_s2_ml  (mmHg s^2/ml, default 0)     B_mmHg_s2_ml2  (mmHg s^2/ml^2,
//   default 0)
// It opens when dp crosses 0 upward and closes when Q crosses 0 downward. Without L the flow follows dp at
// once, R Q + B Q|Q| = dp. Both thresholds lie a hair (1e-10 mmHg, ml/s) beyond zero: to switch back, the
// valve has to cross that band, so that a grazing dp cannot make it chatter. Starts closed. State: Q (ml/s),
// only with L > 0. Source: Bernoulli term and inertance as in Mynard et al., Int J Numer Meth Biomed Engng 28
// (2012) 626-641, without the leaflets' motion.
#pragma once

#include "lumped/element_types.hpp"

namespace valsalva::lumped {

struct ValveParameters {
  double R, L, B;
};

class Valve final : public Element {
 public:
  Valve(std::string name, std::vector<int> nodes, ValveParameters parameters);

  std::vector<StateVariable> states() const override;
  void connect(Instant now, LocalState state, NodalCircuit& circuit) const override;
  void rates(Instant now, LocalState state, const NodalCircuit& circuit, double* dydt) const override;
  double flow(Instant now, LocalState state, const NodalCircuit& circuit) const override;
  bool switches() const override { return true; }
  double switch_margin(LocalState state, const NodalCircuit& circuit) const override;
  void on_switch(bool open, double* y) const override;

 private:
  bool has_inertia() const { return parameters_.L > 0.0; }
  double pressure_drop(const NodalCircuit& circuit) const
  {
    return circuit.pressure(node(0)) - circuit.pressure(node(1));
  }

  ValveParameters parameters_;
};

ElementType valve_type();

}  // namespace valsalva::lumped
