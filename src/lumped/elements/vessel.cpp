#include "lumped/elements/vessel.hpp"

namespace valsalva::lumped {

template <class Scalar>
Vessel<Scalar>::Vessel(const ElementInput<Scalar>& input)
    : Element<Scalar>(input),
      branch_{input.number("R_mmHg_s_ml"), input.number("L_mmHg_s2_ml"), input.number("S_mmHg_s2_ml2")},
      C_(input.number("C_ml_mmHg")),
      initial_pressure_(input.number("initial_pressure_mmHg")),
      wall_terminal_(input.word("wall") == "inlet" ? 0 : 1)
{
}

template <class Scalar>
NodeRole Vessel<Scalar>::role(int terminal) const
{
  return terminal == wall_terminal_ && has_wall() ? NodeRole::fixes : NodeRole::none;
}

template <class Scalar>
std::vector<StateVariable<Scalar>> Vessel<Scalar>::states() const
{
  std::vector<StateVariable<Scalar>> all;
  if (branch_.has_inertia()) all.push_back({"Q_ml_s", "ml/s", 0.0});
  if (has_wall()) all.push_back({"P_mmHg", "mmHg", initial_pressure_});
  return all;
}

template <class Scalar>
void Vessel<Scalar>::connect(Instant, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const
{
  if (has_wall()) circuit.hold_pressure(node(wall_terminal_), state.y[wall()]);
  branch_.connect(node(0), node(1), state.y, circuit);
}

template <class Scalar>
void Vessel<Scalar>::rates(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
                           Scalar* dydt) const
{
  if (branch_.has_inertia()) dydt[0] = branch_.rate(pressure_drop(circuit), state.y[0]);
  if (has_wall()) dydt[wall()] = circuit.flow_into_holder(node(wall_terminal_)) / C_;
}

template <class Scalar>
Scalar Vessel<Scalar>::flow(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const
{
  return branch_.flow(pressure_drop(circuit), state.y);
}

template <class Scalar>
Scalar Vessel<Scalar>::energy(LocalState<Scalar> state) const
{
  const Scalar of_flow = branch_.energy(state.y);
  return has_wall() ? of_flow + 0.5 * C_ * state.y[wall()] * state.y[wall()] : of_flow;
}

template <class Scalar>
Exchange<Scalar> Vessel<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                          const NodalCircuit<Scalar>& circuit) const
{
  return {.loss = branch_.loss(flow(now, state, circuit))};
}

template <class Scalar>
Scalar Vessel<Scalar>::volume(LocalState<Scalar> state) const
{
  return has_wall() ? C_ * state.y[wall()] : Scalar(0.0);
}

namespace {

ElementParameter part(const std::string& name, const std::string& unit, const std::string& quantity,
                      const std::string& meaning)
{
  return {.name = name,
          .unit = unit,
          .quantity = quantity,
          .default_number = 0.0,
          .lowest = 0.0,
          .meaning = meaning};
}

void check_vessel(const ElementSpec& e, double, std::vector<CaseProblem>& problems)
{
  if (e.numbers.at("R_mmHg_s_ml") == 0.0 && e.numbers.at("L_mmHg_s2_ml") == 0.0)
    problems.push_back({"", 0, 0, element_key(e, "R_mmHg_s_ml"),
                        "is 0, and so is L_mmHg_s2_ml: nothing stands between the nodes \"" +
                            e.nodes.at("from") + "\" and \"" + e.nodes.at("to") +
                            "\". Give one of the two, or let both be one node."});
}

}  // namespace

ElementType vessel_type()
{
  return {.name = "vessel",
          .terminals = {"from", "to"},
          .parameters = {part("R_mmHg_s_ml", "mmHg s/ml", "a resistance", "Resistance of the segment"),
                         part("L_mmHg_s2_ml", "mmHg s^2/ml", "an inertance", "Inertance of the blood in it"),
                         part("C_ml_mmHg", "ml/mmHg", "a compliance", "Compliance of its wall"),
                         part("S_mmHg_s2_ml2", "mmHg s^2/ml^2", "a stenosis coefficient",
                              "Pressure lost in a stenosis per squared flow"),
                         {.name = "wall",
                          .kind = ParameterKind::word,
                          .quantity = "a place",
                          .default_word = "outlet",
                          .choices = {"outlet", "inlet"},
                          .meaning = "Node whose pressure the compliance fixes"},
                         {.name = "initial_pressure_mmHg",
                          .unit = "mmHg",
                          .quantity = "a pressure",
                          .default_number = 0.0,
                          .meaning = "Pressure of the wall at the start"}},
          .meaning = "Vessel: L dQ/dt = dp - R Q - S Q|Q|, C dP/dt = flow into its wall",
          .factory = make_element<Vessel, double>,
          .dual_factory = make_element<Vessel, Dual>,
          .check = check_vessel};
}

}  // namespace valsalva::lumped
