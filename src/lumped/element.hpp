// One element of a lumped network: what it does at its nodes, and how its states change. mmHg, ml, s.
//   connect  tells the nodal circuit what the element is at this instant: a pressure behind a resistance, a
//   flow,
//            a resistor between two nodes
//   rates    dy/dt of its own states, once the circuit is solved
// An element is immutable; its states live in LumpedState and are handed in as `LocalState`. Flow through an
// element with one terminal is counted from the node into the element, with two terminals from -> to.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lumped/nodal_circuit.hpp"

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
struct StateVariable {
  std::string name;
  std::string unit;
  double initial;
};

struct LocalState {
  const double* y;  ///< the element's own states
  bool open;        ///< of a valve
};

/// What an element does to the pressure of a node.
enum class NodeRole {
  none,        ///< nothing at times (a closed valve) or ever (a given flow)
  determines,  ///< always a pressure behind a resistance
  fixes        ///< at least at times the node's pressure itself
};

class Element {
 public:
  Element(std::string name, std::vector<int> nodes) : name_(std::move(name)), nodes_(std::move(nodes)) {}
  virtual ~Element() = default;
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;

  const std::string& name() const { return name_; }
  int node(int terminal) const { return nodes_[static_cast<std::size_t>(terminal)]; }
  const std::vector<int>& nodes() const { return nodes_; }

  virtual NodeRole role() const { return NodeRole::none; }
  virtual std::vector<StateVariable> states() const { return {}; }
  virtual void connect(Instant now, LocalState state, NodalCircuit& circuit) const = 0;
  virtual void rates(Instant, LocalState, const NodalCircuit&, double* /*dydt*/) const {}
  /// ml/s.
  virtual double flow(Instant now, LocalState state, const NodalCircuit& circuit) const = 0;
  /// The smallest time more than kTimeResolution_s after `t` at which a formula changes; infinity if none.
  virtual double next_kink(double /*t*/) const { return std::numeric_limits<double>::infinity(); }

  /// Only of valves: positive while the valve stays as it is; it switches where this crosses zero.
  virtual bool switches() const { return false; }
  virtual double switch_margin(LocalState, const NodalCircuit&) const { return 1.0; }
  /// Adapts the states to the new position.
  virtual void on_switch(bool /*open*/, double* /*y*/) const {}

 private:
  std::string name_;
  std::vector<int> nodes_;
};

}  // namespace valsalva::lumped
