// Heart valve as an orifice whose leaflets open and close at a finite rate.
//
//     from o--->--|>|--[ R ]--[ Lv ]--[ B ]--[ L ]--o to    (L + Lv) dQ/dt = dp - R Q - B Q|Q|,   dp = P_from - P_to
//           Q                                               A = A_closed + (A_open - A_closed) zeta
//                                                           Lv = rho l/A,   B = rho/(2 A^2)
//     d zeta/dt = (1 - zeta) K_open dv   while dv > 0,      zeta K_close dv   while dv < 0,     dv = dp - L dQ/dt
//
//   area_open_cm2, area_closed_cm2  (cm^2; the closed valve leaks through the second)     length_cm  l
//   opening_1_mmHg_s, closing_1_mmHg_s  K_open, K_close (1/(mmHg s))     R_mmHg_s_ml  default 0
//   L_mmHg_s2_ml  inertance of vessels in series with the valve, default 0     density_g_cm3  rho, default 1.06
// The leaflets feel the pressure drop dv across themselves, not the one that accelerates the blood in the
// vessels before and behind them. The flow reverses while they close: a closing volume. Starts closed. States:
// Q (ml/s), zeta (0 shut to 1 open). The integrator stops where dv changes its sign, because the rate of zeta
// has a kink there.
// Source: Mynard, Davidson, Penny & Smolich, Int J Numer Meth Biomed Engng 28 (2012) 626-641; L is an addition.
#pragma once

#include "lumped/network/branch.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class OrificeValve final : public Element<Scalar> {
 public:
  explicit OrificeValve(const ElementInput<Scalar>& input);

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

 private:
  using Element<Scalar>::node;
  using Element<Scalar>::pressure_drop;
  /// cm^2.
  Scalar area(LocalState<Scalar> state) const
  {
    return area_closed_ + (area_open_ - area_closed_) * state.y[1];
  }
  Branch<Scalar> branch_at(const Scalar& area) const;
  /// d zeta/dt, 1/s.
  Scalar opening_rate(LocalState<Scalar> state, const Scalar& dv) const;

  /// dv, mmHg.
  Scalar drop_at_leaflets(LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const;

  Scalar area_open_, area_closed_, length_, opening_, closing_, R_, L_;
  Scalar density_;  ///< mmHg s^2/cm^2
};

ElementType orifice_valve_type();

}  // namespace valsalva::lumped
