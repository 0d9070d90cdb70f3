#include "lumped/elements/pressure_source.hpp"

namespace valsalva::lumped {

namespace {
constexpr const char* kValueKey = "pressure_mmHg";
}

template <class Scalar>
PressureSource<Scalar>::PressureSource(const ElementInput<Scalar>& input)
    : Element<Scalar>(input), pressure_(input, kValueKey)
{
}

template <class Scalar>
void PressureSource<Scalar>::connect(Instant now, LocalState<Scalar>, NodalCircuit<Scalar>& circuit) const
{
  circuit.hold_pressure(node(0), pressure_.value(now));
}

template <class Scalar>
Scalar PressureSource<Scalar>::flow(Instant, LocalState<Scalar>, const NodalCircuit<Scalar>& circuit) const
{
  return -circuit.flow_into_holder(node(0));
}

template <class Scalar>
Exchange<Scalar> PressureSource<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                                  const NodalCircuit<Scalar>& circuit) const
{
  const Scalar Q = flow(now, state, circuit);
  return {.inflow = Q, .work = circuit.pressure(node(0)) * Q};
}

ElementType pressure_source_type()
{
  return {.name = "pressure_source",
          .terminals = {"node"},
          .parameters = waveform_parameters(kValueKey, "mmHg", "a pressure", "Pressure of the node"),
          .meaning = "Prescribed pressure, constant, Fourier series or table in time",
          .factory = make_element<PressureSource, double>,
          .dual_factory = make_element<PressureSource, Dual>,
          .check = [](const ElementSpec& e, double period_s, std::vector<CaseProblem>& problems) {
            check_waveform(e, kValueKey, period_s, problems);
          }};
}

}  // namespace valsalva::lumped
