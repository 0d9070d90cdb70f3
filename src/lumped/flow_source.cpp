#include "lumped/flow_source.hpp"

namespace valsalva::lumped {

namespace {
constexpr const char* kValueKey = "flow_ml_s";
}

FlowSource::FlowSource(std::string name, std::vector<int> nodes, Waveform flow)
    : Element(std::move(name), std::move(nodes)), flow_(std::move(flow))
{
}

void FlowSource::connect(Instant now, LocalState, NodalCircuit& circuit) const
{
  circuit.add_inflow(node(0), flow_.value(now));
}

double FlowSource::flow(Instant now, LocalState, const NodalCircuit&) const
{
  return flow_.value(now);
}

ElementType flow_source_type()
{
  return {
      .name = "flow_source",
      .terminals = {"node"},
      .parameters = waveform_parameters(kValueKey, "ml/s", "a flow", "Flow into the node"),
      .meaning = "Prescribed flow into a node, constant or piecewise linear in time",
      .factory = [](const ElementSpec& e, const std::vector<int>& nodes,
                    double period_s) -> std::unique_ptr<Element> {
        return std::make_unique<FlowSource>(e.name, nodes, read_waveform(e, kValueKey, period_s));
      },
      .check = [](const ElementSpec& e, double period_s,
                  std::vector<CaseProblem>& problems) { check_waveform(e, kValueKey, period_s, problems); }};
}

}  // namespace valsalva::lumped
