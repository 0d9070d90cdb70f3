#include "lumped/elements/flow_source.hpp"

namespace valsalva::lumped {

namespace {
constexpr const char* kValueKey = "flow_ml_s";
}

template <class Scalar>
FlowSource<Scalar>::FlowSource(const ElementInput<Scalar>& input)
    : Element<Scalar>(input), flow_(input, kValueKey)
{
}

template <class Scalar>
void FlowSource<Scalar>::connect(Instant now, LocalState<Scalar>, NodalCircuit<Scalar>& circuit) const
{
  circuit.add_inflow(node(0), flow_.value(now));
}

template <class Scalar>
Scalar FlowSource<Scalar>::flow(Instant now, LocalState<Scalar>, const NodalCircuit<Scalar>&) const
{
  return flow_.value(now);
}

template <class Scalar>
Exchange<Scalar> FlowSource<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                              const NodalCircuit<Scalar>& circuit) const
{
  const Scalar Q = flow(now, state, circuit);
  return {.inflow = Q, .work = circuit.pressure(node(0)) * Q};
}

ElementType flow_source_type()
{
  return {.name = "flow_source",
          .terminals = {"node"},
          .parameters = waveform_parameters(kValueKey, "ml/s", "a flow", "Flow into the node"),
          .meaning = "Prescribed flow into a node, constant, Fourier series or table in time",
          .factory = make_element<FlowSource, double>,
          .dual_factory = make_element<FlowSource, Dual>,
          .check = [](const ElementSpec& e, double period_s, std::vector<CaseProblem>& problems) {
            check_waveform(e, kValueKey, period_s, problems);
          }};
}

}  // namespace valsalva::lumped
