// Heart chamber with a time-varying elastance.
//
//     node o--->--[ R ]----o                         P = E(t) (V - V0) + R Q
//           Q              |                         dV/dt = Q
//                        ( V )                       E = Emin + (Emax - Emin) e(t),  periodic in T
//
//   Emax_mmHg_ml, Emin_mmHg_ml  (mmHg/ml)      V0_ml  volume at zero pressure      initial_volume_ml  V at
//   the start period_s  T, default the case's            R_mmHg_s_ml  source resistance, default 0 activation
//   "double_hill" with n1, n2, tau1_periods, tau2_periods, or "half_cosine" with systole_periods; times
//               as fractions of T; see activation.hpp. Contraction sets in at t = 0, T, 2T, ...
// State: V (ml). Source: Suga & Sagawa, Circ Res 35 (1974) 117-126.
#pragma once

#include "lumped/activation.hpp"
#include "lumped/element_types.hpp"

namespace valsalva::lumped {

struct ChamberParameters {
  double Emax, Emin, V0, initial_volume, period_s, R;
};

class Chamber final : public Element {
 public:
  Chamber(std::string name, std::vector<int> nodes, ChamberParameters parameters, Activation activation);

  NodeRole role() const override { return parameters_.R > 0.0 ? NodeRole::determines : NodeRole::fixes; }
  std::vector<StateVariable> states() const override;
  void connect(Instant now, LocalState state, NodalCircuit& circuit) const override;
  void rates(Instant now, LocalState state, const NodalCircuit& circuit, double* dydt) const override;
  double flow(Instant now, LocalState state, const NodalCircuit& circuit) const override;
  double next_kink(double t) const override;

 private:
  double elastic_pressure(Instant now, double V) const;

  ChamberParameters parameters_;
  Activation activation_;
};

ElementType chamber_type();

}  // namespace valsalva::lumped
