// A prescribed pressure at a node, whatever the flow.
//
//     node o-----( P(t) )-----| 0 mmHg          P_node = P(t)
//
// P(t) in mmHg, constant, Fourier series or table (see waveform.hpp):
//   pressure_mmHg   one number, or a table with time_s (s); or file and column of a CSV
//   cosine_mmHg, sine_mmHg   factors of the harmonics about that one number
//   beyond_table    "hold" (the end values) or "repeat" (every heart period)
// The flow reported is what the source delivers into the node, ml/s.
#pragma once

#include "lumped/elements/waveform.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class PressureSource final : public Element<Scalar> {
 public:
  explicit PressureSource(const ElementInput<Scalar>& input);

  NodeRole role(int) const override { return NodeRole::fixes; }
  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  Scalar next_kink(double t) const override { return pressure_.next_kink(t); }
  bool keeps_volume() const override { return false; }

 private:
  using Element<Scalar>::node;
  Waveform<Scalar> pressure_;
};

ElementType pressure_source_type();

}  // namespace valsalva::lumped
