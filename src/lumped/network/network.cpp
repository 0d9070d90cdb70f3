#include "lumped/network/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lumped/network/complete_spec.hpp"
#include "lumped/network/element_types.hpp"
#include "lumped/network/network_topology.hpp"

namespace valsalva::lumped {

namespace {

/// As seen from after the kink, if there is one at this time.
Instant just_after(double t)
{
  return {t, t + kTimeResolution_s};
}

}  // namespace

template <class Scalar>
Network<Scalar>::Network(const NetworkSpec& spec, std::span<const std::string> seeded)
{
  const NetworkSpec complete = complete_spec(spec);
  const NetworkTopology topology = number_nodes(complete);
  std::vector<std::unique_ptr<Element<Scalar>>> elements;
  std::vector<Joined> joined;
  for (std::size_t e = 0; e < complete.elements.size(); ++e) {
    elements.push_back(
        build_element<Scalar>({complete.elements[e], topology.element_nodes[e], complete.period_s, seeded},
                              complete.elements[e].type));
    joined.push_back({elements.back()->name(), elements.back()->nodes(), {}});
    for (std::size_t terminal = 0; terminal < joined.back().nodes.size(); ++terminal)
      joined.back().roles.push_back(elements.back()->role(static_cast<int>(terminal)));
  }
  check_solvable(topology, joined);

  node_names_ = topology.node_names;
  port_nodes_ = topology.port_nodes;
  for (const std::string& node : node_names_) observables_.push_back({"p_" + node + "_mmHg", "mmHg"});
  for (auto& element : elements) place(std::move(element));
  add_integrals(complete.integrals);
  if (complete.balance) add_balance();
}

template <class Scalar>
void Network<Scalar>::place(std::unique_ptr<Element<Scalar>> element)
{
  observables_.push_back({"Q_" + element->name() + "_ml_s", "ml/s"});
  const int first_state = state_count();
  for (const StateVariable<Scalar>& s : element->states())
    states_.push_back({element->name() + "." + s.name, s.unit, s.initial});
  const int valve = element->switches() ? valve_count() : -1;
  if (valve >= 0) valves_.push_back(static_cast<int>(elements_.size()));
  elements_.push_back({std::move(element), first_state, valve});
}

template <class Scalar>
void Network<Scalar>::add_integrals(const std::vector<std::string>& names)
{
  for (const std::string& name : names) {
    const auto found = std::find_if(observables_.begin(), observables_.end(),
                                    [&](const Quantity& q) { return q.name == name; });
    if (found == observables_.end())
      throw CaseError("integral",
                      fmt::format("of \"{}\", which is no pressure or flow of the network", name));
    integrals_.push_back(static_cast<int>(found - observables_.begin()));
    states_.push_back({"integral." + name, found->unit == "ml/s" ? "ml" : found->unit + " s", 0.0});
  }
}

template <class Scalar>
void Network<Scalar>::add_balance()
{
  balances_ = true;
  states_.push_back({"integral.inflow_ml", "ml", 0.0});
  states_.push_back({"integral.work_mmHg_ml", "mmHg ml", 0.0});
  states_.push_back({"integral.loss_mmHg_ml", "mmHg ml", 0.0});
}

template <class Scalar>
std::vector<std::string> Network<Scalar>::valve_names() const
{
  std::vector<std::string> names;
  for (int e : valves_) names.push_back(elements_[static_cast<std::size_t>(e)].element->name());
  return names;
}

template <class Scalar>
NetworkState<Scalar> Network<Scalar>::initial_state() const
{
  NetworkState<Scalar> state;
  for (const StateVariable<Scalar>& s : states_) state.y.push_back(s.initial);
  state.valve_open.assign(valves_.size(), 0);
  NodalCircuit<Scalar> circuit = make_circuit();
  settle_valves(just_after(0.0), state, std::vector<double>(port_nodes_.size(), 0.0), circuit);
  return state;
}

template <class Scalar>
LocalState<Scalar> Network<Scalar>::local_state(const Placed& placed, const Scalar* y,
                                                std::span<const int> valve_open) const
{
  return {y + placed.first_state,
          placed.valve >= 0 && valve_open[static_cast<std::size_t>(placed.valve)] != 0};
}

template <class Scalar>
void Network<Scalar>::solve_circuit(Instant now, const Scalar* y, std::span<const int> valve_open,
                                    std::span<const double> Q, NodalCircuit<Scalar>& circuit) const
{
  circuit.clear();
  for (std::size_t i = 0; i < port_nodes_.size(); ++i) circuit.add_inflow(port_nodes_[i], Q[i]);
  for (const Placed& e : elements_) e.element->connect(now, local_state(e, y, valve_open), circuit);
  circuit.solve();
}

template <class Scalar>
void Network<Scalar>::rates(Instant now, const Scalar* y, std::span<const int> valve_open,
                            std::span<const double> Q, NodalCircuit<Scalar>& circuit, Scalar* dydt) const
{
  solve_circuit(now, y, valve_open, Q, circuit);
  for (const Placed& e : elements_)
    e.element->rates(now, local_state(e, y, valve_open), circuit, dydt + e.first_state);
  Scalar* of_integrals = dydt + state_count() - integral_count();
  for (int number : integrals_) *of_integrals++ = observable(number, now, y, valve_open, circuit);
  if (balances_) balance_rates(now, y, valve_open, Q, circuit, of_integrals);
}

template <class Scalar>
void Network<Scalar>::balance_rates(Instant now, const Scalar* y, std::span<const int> valve_open,
                                    std::span<const double> Q, const NodalCircuit<Scalar>& circuit,
                                    Scalar* rates) const
{
  Exchange<Scalar> total;
  for (const double into : Q) total.inflow += into;
  for (const Placed& e : elements_) {
    const Exchange<Scalar> of_element = e.element->exchange(now, local_state(e, y, valve_open), circuit);
    total.inflow += of_element.inflow;
    total.work += of_element.work;
    total.loss += of_element.loss;
  }
  rates[0] = total.inflow;
  rates[1] = total.work;
  rates[2] = total.loss;
}

template <class Scalar>
void Network<Scalar>::switch_margins(Instant now, const Scalar* y, std::span<const int> valve_open,
                                     std::span<const double> Q, NodalCircuit<Scalar>& circuit,
                                     Scalar* margins) const
{
  solve_circuit(now, y, valve_open, Q, circuit);
  for (std::size_t v = 0; v < valves_.size(); ++v) {
    const Placed& e = elements_[static_cast<std::size_t>(valves_[v])];
    margins[v] = e.element->switch_margin(local_state(e, y, valve_open), circuit);
  }
}

template <class Scalar>
void Network<Scalar>::switch_valve(int valve, NetworkState<Scalar>& state) const
{
  const Placed& e = elements_[static_cast<std::size_t>(valves_[static_cast<std::size_t>(valve)])];
  int& open = state.valve_open[static_cast<std::size_t>(valve)];
  open = open ? 0 : 1;
  e.element->on_switch(open != 0, state.y.data() + e.first_state);
}

template <class Scalar>
std::vector<int> Network<Scalar>::settle_valves(Instant now, NetworkState<Scalar>& state,
                                                std::span<const double> Q,
                                                NodalCircuit<Scalar>& circuit) const
{
  std::vector<int> switched;
  if (valves_.empty()) return switched;
  // Always the first inconsistent valve: with this rule of Murty's the search ends, as the circuit is
  // passive.
  const std::size_t limit = 100 * (valves_.size() + 1);
  std::vector<Scalar> margins(valves_.size());
  while (switched.size() < limit) {
    switch_margins(now, state.y.data(), state.valve_open, Q, circuit, margins.data());
    const auto first = std::find_if(margins.begin(), margins.end(), [](const Scalar& m) { return m <= 0.0; });
    if (first == margins.end()) return switched;
    switched.push_back(static_cast<int>(first - margins.begin()));
    switch_valve(switched.back(), state);
  }
  throw SolverError(fmt::format("the valves of the lumped network find no position at t = {} s", now.t));
}

template <class Scalar>
NodalCircuit<Scalar> Network<Scalar>::circuit_at(const NetworkState<Scalar>& state,
                                                 std::span<const double> Q) const
{
  NodalCircuit<Scalar> circuit = make_circuit();
  solve_circuit(just_after(state.t), state.y.data(), state.valve_open, Q, circuit);
  return circuit;
}

template <class Scalar>
std::vector<Scalar> Network<Scalar>::port_pressures(const NetworkState<Scalar>& state,
                                                    std::span<const double> Q) const
{
  const NodalCircuit<Scalar> circuit = circuit_at(state, Q);
  std::vector<Scalar> p;
  for (int node : port_nodes_) p.push_back(circuit.pressure(node));
  return p;
}

template <class Scalar>
std::vector<Scalar> Network<Scalar>::observe(const NetworkState<Scalar>& state,
                                             std::span<const double> Q) const
{
  const NodalCircuit<Scalar> circuit = circuit_at(state, Q);
  std::vector<Scalar> values;
  for (int number = 0; number < static_cast<int>(observables_.size()); ++number)
    values.push_back(observable(number, just_after(state.t), state.y.data(), state.valve_open, circuit));
  return values;
}

template <class Scalar>
Scalar Network<Scalar>::observable(int number, Instant now, const Scalar* y, std::span<const int> valve_open,
                                   const NodalCircuit<Scalar>& circuit) const
{
  if (number < node_count()) return circuit.pressure(number);
  const Placed& e = elements_[static_cast<std::size_t>(number - node_count())];
  return e.element->flow(now, local_state(e, y, valve_open), circuit);
}

template <class Scalar>
Scalar Network<Scalar>::volume(const NetworkState<Scalar>& state) const
{
  Scalar sum = 0.0;
  for (const Placed& e : elements_)
    sum += e.element->volume(local_state(e, state.y.data(), state.valve_open));
  return sum;
}

template <class Scalar>
Balance Network<Scalar>::balance(const NetworkState<Scalar>& state) const
{
  if (!balances_) throw std::logic_error("the network's spec asks for no balance");
  const auto* integral = state.y.data() + state_count() - kBalanceTerms;
  Scalar energy = 0.0;
  for (const Placed& e : elements_)
    energy += e.element->energy(local_state(e, state.y.data(), state.valve_open));
  return {value_of(integral[0]), value_of(integral[1]), value_of(integral[2]), value_of(volume(state)),
          value_of(energy)};
}

template <class Scalar>
bool Network<Scalar>::keeps_volume() const
{
  return std::all_of(elements_.begin(), elements_.end(),
                     [](const Placed& e) { return e.element->keeps_volume(); });
}

template <class Scalar>
Scalar Network<Scalar>::next_kink(double t) const
{
  Scalar kink = std::numeric_limits<double>::infinity();
  for (const Placed& e : elements_) kink = std::min(kink, e.element->next_kink(t));
  return kink;
}

template class Network<double>;
template class Network<Dual>;

}  // namespace valsalva::lumped
