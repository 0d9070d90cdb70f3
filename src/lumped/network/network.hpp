// A lumped circulation: named elements joined at named nodes, as a system of ordinary differential equations
//     y' = g(t, y; valves, Q)        p = p(t, y; valves, Q)  at the ports
// with y the elements' states, Q the flows through the ports (ml/s, positive INTO the network) and p the
// pressures of the port nodes (mmHg). Each evaluation first finds all node pressures (nodal_circuit.hpp).
// Behind the elements' states stand the integrals over time that the spec asks for, from 0 at the start, last those
// of the balance of volume and energy.
// mmHg, ml, s. Immutable once built; it knows nothing of time stepping. With `Dual` all that it returns
// carries the derivatives along the parameters named at construction.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lumped/network/element.hpp"
#include "lumped/network/lumped_state.hpp"
#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

/// Name and unit of a quantity that is reported.
struct Quantity {
  std::string name;
  std::string unit;
};

/// Blood and energy of a network: what has come and gone since the start, and what is in it. Without ports and
/// without errors of integration, volume - inflow and energy - work + loss stay what they were.
struct Balance {
  double inflow =
      0;            ///< ml, from sources and through ports, less what runs off through peripheral resistances
  double work = 0;  ///< mmHg ml, of sources and contracting walls on the blood
  double loss = 0;  ///< mmHg ml, in resistances
  double volume = 0;  ///< ml in all elements
  double energy = 0;  ///< mmHg ml in compliances and inertances
};

template <class Scalar>
class Network {
 public:
  /// CaseError with all problems: parameters (complete_spec), ports, nodes whose pressure cannot be found.
  explicit Network(const NetworkSpec& spec, std::span<const std::string> seeded = {});

  int state_count() const { return static_cast<int>(states_.size()); }
  int integral_count() const { return static_cast<int>(integrals_.size()) + (balances_ ? kBalanceTerms : 0); }
  int valve_count() const { return static_cast<int>(valves_.size()); }
  int port_count() const { return static_cast<int>(port_nodes_.size()); }
  int node_count() const { return static_cast<int>(node_names_.size()); }
  /// "arteries.Pc_mmHg", "ventricle.V_ml", "aortic.Q_ml_s", with units and values at the start; then the
  /// integrals, "integral.Q_aortic_ml_s".
  const std::vector<StateVariable<Scalar>>& states() const { return states_; }
  const std::vector<std::string>& node_names() const { return node_names_; }
  /// Element names in the order of NetworkState::valve_open.
  std::vector<std::string> valve_names() const;

  /// At t = 0, valves where the pressures without port flow put them.
  NetworkState<Scalar> initial_state() const;
  /// Pressures at the ports, mmHg. At a kink of a source the value after the kink. `Q`: one flow per port,
  /// ml/s.
  std::vector<Scalar> port_pressures(const NetworkState<Scalar>& state, std::span<const double> Q) const;
  /// What `observe` returns: all node pressures "p_<node>_mmHg", then all element flows "Q_<element>_ml_s"
  /// (into a windkessel or chamber, out of a source, from -> to through a valve).
  const std::vector<Quantity>& observables() const { return observables_; }
  /// At the state; at a kink the value after it. `Q`: one flow per port, ml/s.
  std::vector<Scalar> observe(const NetworkState<Scalar>& state, std::span<const double> Q) const;
  /// The smallest time more than kTimeResolution_s after `t` at which a source or chamber has a kink (s);
  /// infinity if there is none.
  Scalar next_kink(double t) const;
  /// Blood in all elements (ml), and whether its total can change only through the ports: a closed loop.
  Scalar volume(const NetworkState<Scalar>& state) const;
  /// Of a network whose spec asks for it; else std::logic_error.
  Balance balance(const NetworkState<Scalar>& state) const;
  bool keeps_volume() const;

  // For integrators. `circuit` is scratch of this network (`make_circuit`); after a call it holds the
  // pressures.
  NodalCircuit<Scalar> make_circuit() const { return NodalCircuit<Scalar>(node_count()); }
  /// All node pressures, left in `circuit`. SolverError if they are not finite.
  void solve_circuit(Instant now, const Scalar* y, std::span<const int> valve_open, std::span<const double> Q,
                     NodalCircuit<Scalar>& circuit) const;
  /// dydt, one entry per state and integral, per s.
  void rates(Instant now, const Scalar* y, std::span<const int> valve_open, std::span<const double> Q,
             NodalCircuit<Scalar>& circuit, Scalar* dydt) const;
  /// Per valve: positive while it stays as it is.
  void switch_margins(Instant now, const Scalar* y, std::span<const int> valve_open,
                      std::span<const double> Q, NodalCircuit<Scalar>& circuit, Scalar* margins) const;
  /// Opens or closes it and lets the element adapt its states.
  void switch_valve(int valve, NetworkState<Scalar>& state) const;
  /// Switches valves, one after the other, until all are consistent with the pressures; returns which.
  std::vector<int> settle_valves(Instant now, NetworkState<Scalar>& state, std::span<const double> Q,
                                 NodalCircuit<Scalar>& circuit) const;

 private:
  void place(std::unique_ptr<Element<Scalar>> element);
  void add_integrals(const std::vector<std::string>& names);
  void add_balance();
  static constexpr int kBalanceTerms = 3;  ///< the first three of `Balance`, as the last states
  struct Placed {
    std::unique_ptr<Element<Scalar>> element;
    int first_state;
    int valve;  ///< -1: not a valve
  };
  LocalState<Scalar> local_state(const Placed& placed, const Scalar* y,
                                 std::span<const int> valve_open) const;
  /// Rates of the balance's terms, in order.
  void balance_rates(Instant now, const Scalar* y, std::span<const int> valve_open, std::span<const double> Q,
                     const NodalCircuit<Scalar>& circuit, Scalar* rates) const;
  Scalar observable(int number, Instant now, const Scalar* y, std::span<const int> valve_open,
                    const NodalCircuit<Scalar>& circuit) const;
  NodalCircuit<Scalar> circuit_at(const NetworkState<Scalar>& state, std::span<const double> Q) const;

  std::vector<Placed> elements_;
  std::vector<int> valves_;  ///< element number per valve
  std::vector<StateVariable<Scalar>> states_;
  std::vector<std::string> node_names_;
  std::vector<int> port_nodes_;
  std::vector<Quantity> observables_;
  std::vector<int> integrals_;  ///< numbers of the integrated observables
  bool balances_ = false;
};

using LumpedNetwork = Network<double>;

}  // namespace valsalva::lumped
