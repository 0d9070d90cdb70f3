// A lumped circulation: named elements joined at named nodes, as a system of ordinary differential equations
//     y' = g(t, y; valves, Q)        p = p(t, y; valves, Q)  at the ports
// with y the elements' states, Q the flows through the ports (ml/s, positive INTO the network) and p the
// pressures of the port nodes (mmHg). Each evaluation first finds all node pressures (nodal_circuit.hpp).
// mmHg, ml, s. Immutable once built; it knows nothing of time stepping.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lumped/element.hpp"
#include "lumped/lumped_state.hpp"
#include "lumped/network_spec.hpp"

namespace valsalva::lumped {

/// Name and unit of a quantity that is reported.
struct Quantity {
  std::string name;
  std::string unit;
};

class LumpedNetwork {
 public:
  /// CaseError with all problems: parameters (complete_spec), ports, nodes whose pressure cannot be found.
  explicit LumpedNetwork(const NetworkSpec& spec);

  int state_count() const { return static_cast<int>(states_.size()); }
  int valve_count() const { return static_cast<int>(valves_.size()); }
  int port_count() const { return static_cast<int>(port_nodes_.size()); }
  int node_count() const { return static_cast<int>(node_names_.size()); }
  /// "arteries.Pc_mmHg", "ventricle.V_ml", "aortic.Q_ml_s", with units and values at the start.
  const std::vector<StateVariable>& states() const { return states_; }
  const std::vector<std::string>& node_names() const { return node_names_; }
  /// Element names in the order of LumpedState::valve_open.
  std::vector<std::string> valve_names() const;

  /// At t = 0, valves where the pressures without port flow put them.
  LumpedState initial_state() const;
  /// Pressures at the ports, mmHg. At a kink of a source the value after the kink. `Q`: one flow per port,
  /// ml/s.
  std::vector<double> port_pressures(const LumpedState& state, std::span<const double> Q) const;
  /// What `observe` returns: all node pressures "p_<node>_mmHg", then all element flows "Q_<element>_ml_s"
  /// (into a windkessel or chamber, out of a source, from -> to through a valve).
  const std::vector<Quantity>& observables() const { return observables_; }
  std::vector<double> observe(const LumpedState& state, std::span<const double> Q) const;
  /// The smallest time more than kTimeResolution_s after `t` at which a source or chamber has a kink (s);
  /// infinity if there is none.
  double next_kink(double t) const;

  // For integrators. `circuit` is scratch of this network (`make_circuit`); after a call it holds the
  // pressures.
  NodalCircuit make_circuit() const { return NodalCircuit(node_count()); }
  void solve_circuit(Instant now, const double* y, std::span<const int> valve_open, std::span<const double> Q,
                     NodalCircuit& circuit) const;
  void rates(Instant now, const double* y, std::span<const int> valve_open, std::span<const double> Q,
             NodalCircuit& circuit, double* dydt) const;
  /// Per valve: positive while it stays as it is.
  void switch_margins(Instant now, const double* y, std::span<const int> valve_open,
                      std::span<const double> Q, NodalCircuit& circuit, double* margins) const;
  void switch_valve(int valve, LumpedState& state) const;
  /// Switches valves, one after the other, until all are consistent with the pressures; returns how often.
  int settle_valves(Instant now, LumpedState& state, std::span<const double> Q, NodalCircuit& circuit) const;

 private:
  struct Placed {
    std::unique_ptr<Element> element;
    int first_state;
    int valve;  ///< -1: not a valve
  };
  LocalState local_state(const Placed& placed, const double* y, std::span<const int> valve_open) const;
  NodalCircuit circuit_at(const LumpedState& state, std::span<const double> Q) const;

  std::vector<Placed> elements_;
  std::vector<int> valves_;  ///< element number per valve
  std::vector<StateVariable> states_;
  std::vector<std::string> node_names_;
  std::vector<int> port_nodes_;
  std::vector<Quantity> observables_;
};

}  // namespace valsalva::lumped
