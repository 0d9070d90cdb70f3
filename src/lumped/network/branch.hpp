// A branch between two nodes with resistance, inertance and a loss that grows with the squared flow:
//     L dQ/dt = dp - R Q - B Q|Q|        dp the pressure drop along it (mmHg), Q its flow (ml/s)
//     R mmHg s/ml      L mmHg s^2/ml      B mmHg s^2/ml^2
// With L = 0 the flow follows dp at once. Valves and vessels are made of it.
// Source: Bernoulli term as in Mynard et al., Int J Numer Meth Biomed Engng 28 (2012) 626-641.
#pragma once

#include "lumped/network/nodal_circuit.hpp"

namespace valsalva::lumped {

/// dQ/dt, ml/s^2; L > 0.
template <class Scalar>
Scalar flow_rate_of_change(const Scalar& dp, const Scalar& Q, const Scalar& R, const Scalar& L,
                           const Scalar& B)
{
  using std::abs;
  return (dp - (R + B * abs(Q)) * Q) / L;
}

template <class Scalar>
struct Branch {
  Scalar R, L, B;

  bool has_inertia() const { return L > 0.0; }
  /// `Q`: the state, read only with inertia.
  void connect(int from, int to, const Scalar* Q, NodalCircuit<Scalar>& circuit) const
  {
    if (has_inertia())
      circuit.add_flow(from, to, *Q);
    else
      circuit.add_resistor(from, to, R, B);
  }
  /// ml/s; `Q`: as in `connect`.
  Scalar flow(const Scalar& dp, const Scalar* Q) const
  {
    return has_inertia() ? *Q : resistor_flow(dp, R, B);
  }
  /// mmHg ml/s and mmHg ml.
  Scalar loss(const Scalar& Q) const
  {
    using std::abs;
    return (R + B * abs(Q)) * Q * Q;
  }
  Scalar energy(const Scalar* Q) const { return has_inertia() ? 0.5 * L * *Q * *Q : Scalar(0.0); }
  /// With inertia only.
  Scalar rate(const Scalar& dp, const Scalar& Q) const { return flow_rate_of_change(dp, Q, R, L, B); }
};

}  // namespace valsalva::lumped
