// One element of a lumped network: what it does at its nodes, and how its states change. mmHg, ml, s.
//   connect  tells the nodal circuit what the element is at this instant: a pressure behind a resistance, a
//            flow, a resistor between two nodes
//   rates    dy/dt of its own states, once the circuit is solved
// Scalar is `double`, or `Dual` for values with their derivatives (dual.hpp). An element always gives the same answer to
// the same question (it may remember the last one: one thread per network); its states live in NetworkState and are handed
// in as `LocalState`. Flow through an element with one terminal is
// counted from the node into the element, with two terminals from -> to.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "lumped/network/element_input.hpp"
#include "lumped/network/nodal_circuit.hpp"

namespace valsalva::lumped {

/// Times closer than this count as one (s).
inline constexpr double kTimeResolution_s = 1e-12;

/// A time, and with it the side from which a kink is seen: `piece` is any time inside the smooth piece
/// (between two kinks) whose formulas hold, so that a step ending on a kink never sees what comes after it.
struct Instant {
  double t;
  double piece;
};

/// A state's name within its element, unit ("mmHg", "ml", "ml/s") and value at the start.
template <class Scalar>
struct StateVariable {
  std::string name;
  std::string unit;
  Scalar initial;
};

/// The part of a NetworkState that an element sees.
template <class Scalar>
struct LocalState {
  const Scalar* y;  ///< the element's own states
  bool open;        ///< of a valve
};

/// What an element does to the pressure of a node.
enum class NodeRole {
  none,        ///< nothing at times (a closed valve) or ever (a given flow)
  determines,  ///< always a pressure behind a resistance
  fixes        ///< at least at times the node's pressure itself
};

/// What an element trades with the world outside the network, and what it turns into heat.
template <class Scalar>
struct Exchange {
  Scalar inflow = 0.0;  ///< blood from outside, ml/s
  Scalar work = 0.0;    ///< power that sources and contracting walls put into the blood, mmHg ml/s
  Scalar loss = 0.0;    ///< power that is lost on the way, mmHg ml/s
};

template <class Scalar>
class Element {
 public:
  explicit Element(const ElementInput<Scalar>& input) : name_(input.name()), nodes_(input.nodes()) {}
  virtual ~Element() = default;
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;

  const std::string& name() const { return name_; }
  int node(int terminal) const { return nodes_[static_cast<std::size_t>(terminal)]; }
  const std::vector<int>& nodes() const { return nodes_; }

  /// What it does at the node of this terminal (0, or 0 = from and 1 = to).
  virtual NodeRole role(int /*terminal*/) const { return NodeRole::none; }
  /// In the order of LocalState::y and of the rates.
  virtual std::vector<StateVariable<Scalar>> states() const { return {}; }
  virtual void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const = 0;
  virtual void rates(Instant, LocalState<Scalar>, const NodalCircuit<Scalar>&, Scalar* /*dydt*/) const {}
  /// ml/s.
  virtual Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const = 0;
  /// The smallest time more than kTimeResolution_s after `t` at which a formula changes; infinity if none.
  virtual Scalar next_kink(double /*t*/) const { return std::numeric_limits<double>::infinity(); }

  /// Blood held by the element, ml.
  virtual Scalar volume(LocalState<Scalar>) const { return 0.0; }
  /// Stored in compliances and inertances, mmHg ml. With `exchange` it accounts for all power at the terminals:
  ///     sum over terminals of p (flow into the element) = d(energy)/dt + loss - work
  virtual Scalar energy(LocalState<Scalar>) const { return 0.0; }
  virtual Exchange<Scalar> exchange(Instant, LocalState<Scalar>, const NodalCircuit<Scalar>&) const
  {
    return {};
  }
  /// Does all blood that enters it stay in the network? Not in a source, nor through a peripheral resistance
  /// to a fixed pressure.
  virtual bool keeps_volume() const { return true; }

  /// Only of valves: positive while the valve stays as it is; it switches where this crosses zero.
  virtual bool switches() const { return false; }
  virtual Scalar switch_margin(LocalState<Scalar>, const NodalCircuit<Scalar>&) const { return 1.0; }
  /// Adapts the states to the new position.
  virtual void on_switch(bool /*open*/, Scalar* /*y*/) const {}

 protected:
  /// P_from - P_to, mmHg.
  Scalar pressure_drop(const NodalCircuit<Scalar>& circuit) const
  {
    return circuit.pressure(node(0)) - circuit.pressure(node(1));
  }

 private:
  std::string name_;
  std::vector<int> nodes_;
};

}  // namespace valsalva::lumped
