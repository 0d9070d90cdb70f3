// Three-element Windkessel: the arterial tree seen from its root.
//
//     node o--->--[ Rc ]----o----[ Rp ]----o Pd        P = Pc + Rc Q
//           Q               |                          C dPc/dt = Q - (Pc - Pd)/Rp
//                          === C  (pressure Pc)
//                           |
//   Rc_mmHg_s_ml   characteristic resistance, mmHg s/ml; 0 gives the two-element Windkessel
//   Rp_mmHg_s_ml   peripheral resistance, mmHg s/ml        C_ml_mmHg   compliance, ml/mmHg
//   initial_pressure_mmHg   Pc at the start                distal_pressure_mmHg   Pd
//   pressurise_s   while t < pressurise_s the node's pressure is prescribed, initial_pressure t/pressurise_s,
//   and
//                  Pc is held: a 3D root at rest is filled gently. At pressurise_s the node's pressure
//                  becomes free.
// State: Pc (mmHg). Source: Westerhof, Lankhaar & Westerhof, Med Biol Eng Comput 47 (2009) 131-141;
// parameters of the human type-A beat: Stergiopulos, Westerhof & Westerhof, Am J Physiol 276 (1999) H81-H88.
#pragma once

#include "lumped/element_types.hpp"

namespace valsalva::lumped {

struct Windkessel3Parameters {
  double Rc, Rp, C, initial_pressure, distal_pressure, pressurise_s;
};

class Windkessel3 final : public Element {
 public:
  Windkessel3(std::string name, std::vector<int> nodes, Windkessel3Parameters parameters);

  NodeRole role() const override;
  std::vector<StateVariable> states() const override;
  void connect(Instant now, LocalState state, NodalCircuit& circuit) const override;
  void rates(Instant now, LocalState state, const NodalCircuit& circuit, double* dydt) const override;
  double flow(Instant now, LocalState state, const NodalCircuit& circuit) const override;
  double next_kink(double t) const override;

 private:
  bool pressurises(Instant now) const { return now.piece < parameters_.pressurise_s; }

  Windkessel3Parameters parameters_;
};

ElementType windkessel3_type();

}  // namespace valsalva::lumped
