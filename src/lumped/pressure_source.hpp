// A prescribed pressure at a node, whatever the flow.
//
//     node o-----( P(t) )-----| 0 mmHg          P_node = P(t)
//
// P(t) in mmHg, constant or piecewise linear (see waveform.hpp):
//   pressure_mmHg   one number, or a table with time_s (s)
//   beyond_table    "hold" (the end values) or "repeat" (every heart period)
// The flow reported is what the source delivers into the node, ml/s.
#pragma once

#include "lumped/element_types.hpp"
#include "lumped/waveform.hpp"

namespace valsalva::lumped {

class PressureSource final : public Element {
 public:
  PressureSource(std::string name, std::vector<int> nodes, Waveform pressure);

  NodeRole role() const override { return NodeRole::fixes; }
  void connect(Instant now, LocalState state, NodalCircuit& circuit) const override;
  double flow(Instant now, LocalState state, const NodalCircuit& circuit) const override;
  double next_kink(double t) const override { return pressure_.next_kink(t); }

 private:
  Waveform pressure_;
};

ElementType pressure_source_type();

}  // namespace valsalva::lumped
