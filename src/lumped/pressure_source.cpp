#include "lumped/pressure_source.hpp"

namespace valsalva::lumped {

namespace {
constexpr const char* kValueKey = "pressure_mmHg";
}

PressureSource::PressureSource(std::string name, std::vector<int> nodes, Waveform pressure)
    : Element(std::move(name), std::move(nodes)), pressure_(std::move(pressure))
{
}

void PressureSource::connect(Instant now, LocalState, NodalCircuit& circuit) const
{
  circuit.hold_pressure(node(0), pressure_.value(now));
}

double PressureSource::flow(Instant, LocalState, const NodalCircuit& circuit) const
{
  return -circuit.flow_into_holder(node(0));
}

ElementType pressure_source_type()
{
  return {
      .name = "pressure_source",
      .terminals = {"node"},
      .parameters = waveform_parameters(kValueKey, "mmHg", "a pressure", "Pressure of the node"),
      .meaning = "Prescribed pressure, constant or piecewise linear in time",
      .factory = [](const ElementSpec& e, const std::vector<int>& nodes,
                    double period_s) -> std::unique_ptr<Element> {
        return std::make_unique<PressureSource>(e.name, nodes, read_waveform(e, kValueKey, period_s));
      },
      .check = [](const ElementSpec& e, double period_s,
                  std::vector<CaseProblem>& problems) { check_waveform(e, kValueKey, period_s, problems); }};
}

}  // namespace valsalva::lumped
