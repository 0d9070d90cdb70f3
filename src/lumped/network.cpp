#include "lumped/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lumped/complete_spec.hpp"
#include "lumped/element_types.hpp"
#include "lumped/network_topology.hpp"

namespace valsalva::lumped {

namespace {

/// As seen from after the kink, if there is one at this time.
Instant just_after(double t)
{
  return {t, t + kTimeResolution_s};
}

}  // namespace

LumpedNetwork::LumpedNetwork(const NetworkSpec& spec)
{
  const NetworkSpec complete = complete_spec(spec);
  const NetworkTopology topology = number_nodes(complete);
  std::vector<std::unique_ptr<Element>> elements;
  for (std::size_t e = 0; e < complete.elements.size(); ++e) {
    const ElementSpec& element = complete.elements[e];
    elements.push_back(
        find_element_type(element.type)->factory(element, topology.element_nodes[e], complete.period_s));
  }
  check_solvable(topology, elements);

  node_names_ = topology.node_names;
  port_nodes_ = topology.port_nodes;
  for (const std::string& node : node_names_) observables_.push_back({"p_" + node + "_mmHg", "mmHg"});
  for (auto& element : elements) {
    observables_.push_back({"Q_" + element->name() + "_ml_s", "ml/s"});
    const int first_state = state_count();
    for (const StateVariable& s : element->states())
      states_.push_back({element->name() + "." + s.name, s.unit, s.initial});
    const int valve = element->switches() ? valve_count() : -1;
    if (valve >= 0) valves_.push_back(static_cast<int>(elements_.size()));
    elements_.push_back({std::move(element), first_state, valve});
  }
}

std::vector<std::string> LumpedNetwork::valve_names() const
{
  std::vector<std::string> names;
  for (int e : valves_) names.push_back(elements_[static_cast<std::size_t>(e)].element->name());
  return names;
}

LumpedState LumpedNetwork::initial_state() const
{
  LumpedState state;
  for (const StateVariable& s : states_) state.y.push_back(s.initial);
  state.valve_open.assign(valves_.size(), 0);
  NodalCircuit circuit = make_circuit();
  settle_valves(just_after(0.0), state, std::vector<double>(port_nodes_.size(), 0.0), circuit);
  return state;
}

LocalState LumpedNetwork::local_state(const Placed& placed, const double* y,
                                      std::span<const int> valve_open) const
{
  return {y + placed.first_state,
          placed.valve >= 0 && valve_open[static_cast<std::size_t>(placed.valve)] != 0};
}

void LumpedNetwork::solve_circuit(Instant now, const double* y, std::span<const int> valve_open,
                                  std::span<const double> Q, NodalCircuit& circuit) const
{
  circuit.clear();
  for (std::size_t i = 0; i < port_nodes_.size(); ++i) circuit.add_inflow(port_nodes_[i], Q[i]);
  for (const Placed& e : elements_) e.element->connect(now, local_state(e, y, valve_open), circuit);
  circuit.solve();
}

void LumpedNetwork::rates(Instant now, const double* y, std::span<const int> valve_open,
                          std::span<const double> Q, NodalCircuit& circuit, double* dydt) const
{
  solve_circuit(now, y, valve_open, Q, circuit);
  for (const Placed& e : elements_)
    e.element->rates(now, local_state(e, y, valve_open), circuit, dydt + e.first_state);
}

void LumpedNetwork::switch_margins(Instant now, const double* y, std::span<const int> valve_open,
                                   std::span<const double> Q, NodalCircuit& circuit, double* margins) const
{
  solve_circuit(now, y, valve_open, Q, circuit);
  for (std::size_t v = 0; v < valves_.size(); ++v) {
    const Placed& e = elements_[static_cast<std::size_t>(valves_[v])];
    margins[v] = e.element->switch_margin(local_state(e, y, valve_open), circuit);
  }
}

void LumpedNetwork::switch_valve(int valve, LumpedState& state) const
{
  const Placed& e = elements_[static_cast<std::size_t>(valves_[static_cast<std::size_t>(valve)])];
  int& open = state.valve_open[static_cast<std::size_t>(valve)];
  open = open ? 0 : 1;
  e.element->on_switch(open != 0, state.y.data() + e.first_state);
}

int LumpedNetwork::settle_valves(Instant now, LumpedState& state, std::span<const double> Q,
                                 NodalCircuit& circuit) const
{
  if (valves_.empty()) return 0;
  // Always the first inconsistent valve: with this rule of Murty's the search ends, as the circuit is
  // passive.
  const int limit = 100 * (valve_count() + 1);
  std::vector<double> margins(valves_.size());
  for (int switched = 0; switched < limit; ++switched) {
    switch_margins(now, state.y.data(), state.valve_open, Q, circuit, margins.data());
    const auto first = std::find_if(margins.begin(), margins.end(), [](double m) { return m <= 0.0; });
    if (first == margins.end()) return switched;
    switch_valve(static_cast<int>(first - margins.begin()), state);
  }
  throw SolverError(fmt::format("the valves of the lumped network find no position at t = {} s", now.t));
}

NodalCircuit LumpedNetwork::circuit_at(const LumpedState& state, std::span<const double> Q) const
{
  NodalCircuit circuit = make_circuit();
  solve_circuit(just_after(state.t), state.y.data(), state.valve_open, Q, circuit);
  return circuit;
}

std::vector<double> LumpedNetwork::port_pressures(const LumpedState& state, std::span<const double> Q) const
{
  const NodalCircuit circuit = circuit_at(state, Q);
  std::vector<double> p;
  for (int node : port_nodes_) p.push_back(circuit.pressure(node));
  return p;
}

std::vector<double> LumpedNetwork::observe(const LumpedState& state, std::span<const double> Q) const
{
  const NodalCircuit circuit = circuit_at(state, Q);
  std::vector<double> values;
  for (int node = 0; node < node_count(); ++node) values.push_back(circuit.pressure(node));
  for (const Placed& e : elements_)
    values.push_back(
        e.element->flow(just_after(state.t), local_state(e, state.y.data(), state.valve_open), circuit));
  return values;
}

double LumpedNetwork::next_kink(double t) const
{
  double kink = std::numeric_limits<double>::infinity();
  for (const Placed& e : elements_) kink = std::min(kink, e.element->next_kink(t));
  return kink;
}

}  // namespace valsalva::lumped
