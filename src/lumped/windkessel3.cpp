#include "lumped/windkessel3.hpp"

namespace valsalva::lumped {

Windkessel3::Windkessel3(std::string name, std::vector<int> nodes, Windkessel3Parameters parameters)
    : Element(std::move(name), std::move(nodes)), parameters_(parameters)
{
}

NodeRole Windkessel3::role() const
{
  return parameters_.Rc > 0.0 && parameters_.pressurise_s <= 0.0 ? NodeRole::determines : NodeRole::fixes;
}

std::vector<StateVariable> Windkessel3::states() const
{
  return {{"Pc_mmHg", "mmHg", parameters_.initial_pressure}};
}

void Windkessel3::connect(Instant now, LocalState state, NodalCircuit& circuit) const
{
  if (pressurises(now))
    circuit.hold_pressure(node(0), parameters_.initial_pressure * (now.t / parameters_.pressurise_s));
  else if (parameters_.Rc > 0.0)
    circuit.add_pressure(node(0), state.y[0], parameters_.Rc);
  else
    circuit.hold_pressure(node(0), state.y[0]);
}

void Windkessel3::rates(Instant now, LocalState state, const NodalCircuit& circuit, double* dydt) const
{
  const double Q = flow(now, state, circuit);
  dydt[0] = pressurises(now)
                ? 0.0
                : (Q - (state.y[0] - parameters_.distal_pressure) / parameters_.Rp) / parameters_.C;
}

double Windkessel3::flow(Instant now, LocalState state, const NodalCircuit& circuit) const
{
  if (pressurises(now) || parameters_.Rc == 0.0) return circuit.flow_into_holder(node(0));
  return (circuit.pressure(node(0)) - state.y[0]) / parameters_.Rc;
}

double Windkessel3::next_kink(double t) const
{
  return t + kTimeResolution_s < parameters_.pressurise_s ? parameters_.pressurise_s
                                                          : std::numeric_limits<double>::infinity();
}

ElementType windkessel3_type()
{
  return {
      .name = "windkessel3",
      .terminals = {"node"},
      .parameters = {{.name = "Rc_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a resistance",
                      .lowest = 0.0,
                      .usual = 0.033,
                      .meaning = "Characteristic resistance; 0 gives the two-element Windkessel"},
                     {.name = "Rp_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a peripheral resistance",
                      .lowest = 0.0,
                      .lowest_excluded = true,
                      .usual = 0.79,
                      .meaning = "Peripheral resistance"},
                     {.name = "C_ml_mmHg",
                      .unit = "ml/mmHg",
                      .quantity = "a compliance",
                      .lowest = 0.0,
                      .lowest_excluded = true,
                      .usual = 1.75,
                      .meaning = "Arterial compliance"},
                     {.name = "initial_pressure_mmHg",
                      .unit = "mmHg",
                      .quantity = "a pressure",
                      .usual = 80.0,
                      .meaning = "Pressure of the compliance at the start"},
                     {.name = "distal_pressure_mmHg",
                      .unit = "mmHg",
                      .quantity = "a pressure",
                      .default_number = 0.0,
                      .meaning = "Pressure behind the peripheral resistance"},
                     {.name = "pressurise_s",
                      .unit = "s",
                      .quantity = "a time",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .meaning = "Until then the node's pressure rises linearly to the initial pressure"}},
      .meaning = "Arterial tree: P = Pc + Rc Q, C dPc/dt = Q - (Pc - Pd)/Rp",
      .factory = [](const ElementSpec& e, const std::vector<int>& nodes, double) -> std::unique_ptr<Element> {
        const auto number = [&](const char* key) { return e.numbers.at(key); };
        return std::make_unique<Windkessel3>(
            e.name, nodes,
            Windkessel3Parameters{number("Rc_mmHg_s_ml"), number("Rp_mmHg_s_ml"), number("C_ml_mmHg"),
                                  number("initial_pressure_mmHg"), number("distal_pressure_mmHg"),
                                  number("pressurise_s")});
      }};
}

}  // namespace valsalva::lumped
