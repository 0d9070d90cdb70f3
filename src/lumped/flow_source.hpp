// A prescribed flow into a node, whatever the pressure.
//
//     | 0 mmHg -----( Q(t) -> )-----o node      inflow of the node = Q(t)
//
// Q(t) in ml/s, positive into the node, constant or piecewise linear (see waveform.hpp):
//   flow_ml_s       one number, or a table with time_s (s)
//   beyond_table    "hold" (the end values) or "repeat" (every heart period)
#pragma once

#include "lumped/element_types.hpp"
#include "lumped/waveform.hpp"

namespace valsalva::lumped {

class FlowSource final : public Element {
 public:
  FlowSource(std::string name, std::vector<int> nodes, Waveform flow);

  void connect(Instant now, LocalState state, NodalCircuit& circuit) const override;
  double flow(Instant now, LocalState state, const NodalCircuit& circuit) const override;
  double next_kink(double t) const override { return flow_.next_kink(t); }

 private:
  Waveform flow_;
};

ElementType flow_source_type();

}  // namespace valsalva::lumped
