// Node pressures of a resistive circuit at one instant (mmHg, ml/s, mmHg s/ml).
// Every node has a pressure equivalent of its own: it is held at a pressure (Z = 0), or pressures p_k behind
// resistances R_k and given inflows q_k determine it,
//     P_n = Z_n (sum p_k/R_k + sum q_k + flow from resistors),   1/Z_n = sum 1/R_k.
// Resistors between nodes (open valves) carry Q with  P_from - P_to = R Q + B Q|Q|.  With the node equations
// this is  R Q_i + B Q_i|Q_i| + sum_j Z_ij Q_j = dP_i : strictly monotone, hence one solution. A resistor
// that shares no free node with another has a closed form; otherwise Newton on the flows. With `Dual` the last
// Newton step gives the exact tangents, because it starts from the solution.
#pragma once

#include <vector>

#include "lumped/network/dual.hpp"

namespace valsalva::lumped {

/// The flow Q with R Q + B Q|Q| = dp; R > 0, or B > 0, both >= 0. ml/s.
template <class Scalar>
Scalar resistor_flow(const Scalar& dp, const Scalar& R, const Scalar& B)
{
  using std::abs, std::sqrt;
  // The solution of the quadratic without the difference of two large numbers; exact for B = 0 as well.
  return 2.0 * dp / (R + sqrt(R * R + 4.0 * B * abs(dp)));
}

template <class Scalar>
class NodalCircuit {
 public:
  /// Of that many nodes, nothing connected.
  explicit NodalCircuit(int nodes);

  /// Disconnects everything.
  void clear();
  /// Z = 0: whatever flows, the node has the pressure p.
  void hold_pressure(int node, const Scalar& p);
  /// A branch from pressure p through the resistance R > 0 to the node.
  void add_pressure(int node, const Scalar& p, const Scalar& R);
  /// A given flow into the node.
  void add_inflow(int node, const Scalar& Q);
  /// A given flow from one node to another.
  void add_flow(int from, int to, const Scalar& Q)
  {
    at(from).inflow -= Q;
    at(to).inflow += Q;
  }
  /// R Q + B Q|Q| = P_from - P_to; R, B >= 0, not both 0.
  void add_resistor(int from, int to, const Scalar& R, const Scalar& B);

  /// Finds all pressures. SolverError if Newton does not converge (values that are not finite).
  void solve();

  /// mmHg, once solved.
  const Scalar& pressure(int node) const { return nodes_[static_cast<std::size_t>(node)].pressure; }
  /// What flows into the element that holds this node's pressure.
  const Scalar& flow_into_holder(int node) const { return nodes_[static_cast<std::size_t>(node)].excess; }

 private:
  struct Node {
    bool held = false;
    Scalar held_pressure = 0.0;
    Scalar inflow = 0.0;       ///< sum of p/R and of given flows
    Scalar conductance = 0.0;  ///< sum of 1/R
    Scalar impedance = 0.0;    ///< Z
    int resistors = 0;
    Scalar resistor_inflow = 0.0;
    Scalar pressure = 0.0;
    Scalar excess = 0.0;
  };
  struct Resistor {
    int from, to;
    Scalar R, B, Q;
  };
  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  bool resistors_are_coupled() const;
  void solve_coupled_resistors();

  std::vector<Node> nodes_;
  std::vector<Resistor> resistors_;
  std::vector<Scalar> impedance_, jacobian_;  ///< of the resistors among each other, row by row
  std::vector<Scalar> drive_, Q_, residual_;
};

}  // namespace valsalva::lumped
