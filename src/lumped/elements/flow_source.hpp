// A prescribed flow into a node, whatever the pressure.
//
//     | 0 mmHg -----( Q(t) -> )-----o node      inflow of the node = Q(t)
//
// Q(t) in ml/s, positive into the node, constant, Fourier series or table (see waveform.hpp):
//   flow_ml_s       one number, or a table with time_s (s); or file and column of a CSV
//   cosine_ml_s, sine_ml_s   factors of the harmonics about that one number
//   beyond_table    "hold" (the end values) or "repeat" (every heart period)
#pragma once

#include "lumped/elements/waveform.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class FlowSource final : public Element<Scalar> {
 public:
  explicit FlowSource(const ElementInput<Scalar>& input);

  void connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const override;
  Scalar flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const override;
  Exchange<Scalar> exchange(Instant now, LocalState<Scalar> state,
                            const NodalCircuit<Scalar>& circuit) const override;
  Scalar next_kink(double t) const override { return flow_.next_kink(t); }
  bool keeps_volume() const override { return false; }

 private:
  using Element<Scalar>::node;
  Waveform<Scalar> flow_;
};

ElementType flow_source_type();

}  // namespace valsalva::lumped
