#include "lumped/elements/valve.hpp"

namespace valsalva::lumped {

namespace {
constexpr double kBand = 1e-10;  // mmHg, ml/s
}

template <class Scalar>
Valve<Scalar>::Valve(const ElementInput<Scalar>& input)
    : Element<Scalar>(input),
      branch_{input.number("R_mmHg_s_ml"), input.number("L_mmHg_s2_ml"), input.number("B_mmHg_s2_ml2")}
{
}

template <class Scalar>
std::vector<StateVariable<Scalar>> Valve<Scalar>::states() const
{
  if (!branch_.has_inertia()) return {};
  return {{"Q_ml_s", "ml/s", 0.0}};
}

template <class Scalar>
void Valve<Scalar>::connect(Instant, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const
{
  if (state.open) branch_.connect(node(0), node(1), state.y, circuit);
}

template <class Scalar>
void Valve<Scalar>::rates(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
                          Scalar* dydt) const
{
  if (branch_.has_inertia())
    dydt[0] = state.open ? branch_.rate(pressure_drop(circuit), state.y[0]) : Scalar(0.0);
}

template <class Scalar>
Scalar Valve<Scalar>::flow(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const
{
  return state.open ? branch_.flow(pressure_drop(circuit), state.y) : Scalar(0.0);
}

template <class Scalar>
Scalar Valve<Scalar>::energy(LocalState<Scalar> state) const
{
  return branch_.energy(state.y);
}

template <class Scalar>
Exchange<Scalar> Valve<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                         const NodalCircuit<Scalar>& circuit) const
{
  return {.loss = branch_.loss(flow(now, state, circuit))};
}

template <class Scalar>
Scalar Valve<Scalar>::switch_margin(LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const
{
  if (!state.open) return kBand - pressure_drop(circuit);
  return kBand + (branch_.has_inertia() ? state.y[0] : pressure_drop(circuit));
}

template <class Scalar>
void Valve<Scalar>::on_switch(bool, Scalar* y) const
{
  if (branch_.has_inertia()) y[0] = 0.0;
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
      .factory = make_element<Valve, double>,
      .dual_factory = make_element<Valve, Dual>,
      .check = [](const ElementSpec& e, double, std::vector<CaseProblem>& problems) {
        if (e.numbers.at("R_mmHg_s_ml") == 0.0 && e.numbers.at("L_mmHg_s2_ml") == 0.0)
          problems.push_back(
              {"", 0, 0, element_key(e, "R_mmHg_s_ml"),
               "is 0 in a valve without inertance, whose flow would be undefined; give a small "
               "resistance (0.005 mmHg s/ml) or L_mmHg_s2_ml."});
      }};
}

}  // namespace valsalva::lumped
