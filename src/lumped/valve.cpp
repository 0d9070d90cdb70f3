#include "lumped/valve.hpp"

#include <cmath>

namespace valsalva::lumped {

namespace {
constexpr double kBand = 1e-10;  // mmHg, ml/s
}

Valve::Valve(std::string name, std::vector<int> nodes, ValveParameters parameters)
    : Element(std::move(name), std::move(nodes)), parameters_(parameters)
{
}

std::vector<StateVariable> Valve::states() const
{
  if (!has_inertia()) return {};
  return {{"Q_ml_s", "ml/s", 0.0}};
}

void Valve::connect(Instant, LocalState state, NodalCircuit& circuit) const
{
  if (!state.open) return;
  if (has_inertia()) {
    circuit.add_inflow(node(0), -state.y[0]);
    circuit.add_inflow(node(1), state.y[0]);
  } else {
    circuit.add_resistor(node(0), node(1), parameters_.R, parameters_.B);
  }
}

void Valve::rates(Instant, LocalState state, const NodalCircuit& circuit, double* dydt) const
{
  if (!has_inertia()) return;
  const double Q = state.y[0];
  const double loss = (parameters_.R + parameters_.B * std::abs(Q)) * Q;
  dydt[0] = state.open ? (pressure_drop(circuit) - loss) / parameters_.L : 0.0;
}

double Valve::flow(Instant, LocalState state, const NodalCircuit& circuit) const
{
  if (!state.open) return 0.0;
  return has_inertia() ? state.y[0] : resistor_flow(pressure_drop(circuit), parameters_.R, parameters_.B);
}

double Valve::switch_margin(LocalState state, const NodalCircuit& circuit) const
{
  if (!state.open) return kBand - pressure_drop(circuit);
  return kBand + (has_inertia() ? state.y[0] : pressure_drop(circuit));
}

void Valve::on_switch(bool, double* y) const
{
  if (has_inertia()) y[0] = 0.0;
}

ElementType valve_type()
{
  return {
      .name = "valve",
      .terminals = {"from", "to"},
      .parameters =
          {{.name = "R_mmHg_s_ml",
            .unit = "mmHg s/ml",
            .quantity = "a resistance",
            .lowest = 0.0,
            .usual = 0.01,
            .meaning = "Resistance of the open valve; above 0 unless it has an inertance"},
           {.name = "L_mmHg_s2_ml",
            .unit = "mmHg s^2/ml",
            .quantity = "an inertance",
            .default_number = 0.0,
            .lowest = 0.0,
            .usual = 0.0003,
            .meaning = "Inertance of the blood in the open valve; 0: the flow follows the pressures at once"},
           {.name = "B_mmHg_s2_ml2",
            .unit = "mmHg s^2/ml^2",
            .quantity = "a Bernoulli coefficient",
            .default_number = 0.0,
            .lowest = 0.0,
            .usual = 1.6e-5,
            .meaning = "Pressure lost in the jet per squared flow, rho/(2 area^2)"}},
      .meaning = "Valve: L dQ/dt = dp - R Q - B Q|Q| while open, no backflow",
      .factory = [](const ElementSpec& e, const std::vector<int>& nodes, double) -> std::unique_ptr<Element> {
        return std::make_unique<Valve>(
            e.name, nodes,
            ValveParameters{e.numbers.at("R_mmHg_s_ml"), e.numbers.at("L_mmHg_s2_ml"),
                            e.numbers.at("B_mmHg_s2_ml2")});
      },
      .check =
          [](const ElementSpec& e, double, std::vector<CaseProblem>& problems) {
            if (e.numbers.at("R_mmHg_s_ml") == 0.0 && e.numbers.at("L_mmHg_s2_ml") == 0.0)
              problems.push_back(
                  {"", 0, 0, element_key(e, "R_mmHg_s_ml"),
                   "is 0 in a valve without inertance, whose flow would be undefined; give a small "
                   "resistance (0.005 mmHg s/ml) or L_mmHg_s2_ml."});
          }};
}

}  // namespace valsalva::lumped
