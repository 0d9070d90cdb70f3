// Segment of a vessel: resistance R, stenosis loss S, inertance L of the blood in it and compliance C of its
// wall, at its outlet or at its inlet. Each of them may be zero.
//
//     from o--->--[ R, S ]--[ L ]--+--o to      dp = P_from - P_to
//           Q                      |            L dQ/dt = dp - R Q - S Q|Q|     (L = 0: the right side is 0)
//                                 === C         C dP/dt = flow into the node of the wall
//                                  |
//   R_mmHg_s_ml  (mmHg s/ml)     L_mmHg_s2_ml  (mmHg s^2/ml)     C_ml_mmHg  (ml/mmHg)
//   S_mmHg_s2_ml2  (mmHg s^2/ml^2)     wall  "outlet" (default) or "inlet", the node of C
//   initial_pressure_mmHg  P at the start, with C only
// The wall fixes the pressure of its node; the other one's is another element's matter. Of R and L at least
// one must be positive, or the two nodes would be one. States: Q (ml/s) if L > 0, P (mmHg, of the wall) if
// C > 0. Source: Formaggia, Quarteroni & Veneziani, Cardiovascular Mathematics, Springer 2009, chapter 10;
// stenosis: Young & Tsai, J Biomech 6 (1973) 395-410.
#pragma once

#include "lumped/network/branch.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class Vessel final : public Element<Scalar> {
 public:
  explicit Vessel(const ElementInput<Scalar>& input);

  NodeRole role(int terminal) const override;
  std::vector<StateVariable<Scalar>> states() const override;
  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  void rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
             Scalar* dydt) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Scalar energy(LocalState<Scalar> state) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  Scalar volume(LocalState<Scalar> state) const override;

 private:
  using Element<Scalar>::node;
  using Element<Scalar>::pressure_drop;
  bool has_wall() const { return C_ > 0.0; }
  std::size_t wall() const { return branch_.has_inertia() ? 1 : 0; }  ///< number of the wall's state

  Branch<Scalar> branch_;  ///< its B is S
  Scalar C_, initial_pressure_;
  int wall_terminal_;
};

ElementType vessel_type();

}  // namespace valsalva::lumped
