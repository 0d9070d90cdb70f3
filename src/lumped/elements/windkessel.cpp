#include "lumped/elements/windkessel.hpp"

namespace valsalva::lumped {

template <class Scalar>
Windkessel<Scalar>::Windkessel(const ElementInput<Scalar>& input)
    : Element<Scalar>(input),
      Rc_(input.number("Rc_mmHg_s_ml")),
      Rp_(input.number("Rp_mmHg_s_ml")),
      C_(input.number("C_ml_mmHg")),
      initial_pressure_(input.number("initial_pressure_mmHg")),
      distal_pressure_(input.number("distal_pressure_mmHg")),
      pressurise_s_(input.number("pressurise_s")),
      has_inertance_(input.has("L_mmHg_s2_ml")),
      L_(has_inertance_ ? input.number("L_mmHg_s2_ml") : Scalar(0.0))
{
}

template <class Scalar>
NodeRole Windkessel<Scalar>::role(int) const
{
  return Rc_ > 0.0 && pressurise_s_ <= 0.0 ? NodeRole::determines : NodeRole::fixes;
}

template <class Scalar>
std::vector<StateVariable<Scalar>> Windkessel<Scalar>::states() const
{
  std::vector<StateVariable<Scalar>> all{{"Pc_mmHg", "mmHg", initial_pressure_}};
  if (has_inertance_) all.push_back({"QL_ml_s", "ml/s", 0.0});
  return all;
}

template <class Scalar>
void Windkessel<Scalar>::connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const
{
  if (pressurises(now))
    circuit.hold_pressure(node(0), initial_pressure_ * (now.t / pressurise_s_));
  else if (Rc_ > 0.0)
    circuit.add_pressure(node(0), pressure_behind(state), Rc_);
  else
    circuit.hold_pressure(node(0), state.y[0]);
}

template <class Scalar>
void Windkessel<Scalar>::rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
                               Scalar* dydt) const
{
  const Scalar Q = flow(now, state, circuit);
  const bool held = pressurises(now);
  dydt[0] = held ? Scalar(0.0) : (Q - (state.y[0] - distal_pressure_) / Rp_) / C_;
  if (has_inertance_) dydt[1] = held ? Scalar(0.0) : Rc_ / L_ * (Q - state.y[1]);
}

template <class Scalar>
Scalar Windkessel<Scalar>::flow(Instant now, LocalState<Scalar> state,
                                const NodalCircuit<Scalar>& circuit) const
{
  if (pressurises(now) || !(Rc_ > 0.0)) return circuit.flow_into_holder(node(0));
  return (circuit.pressure(node(0)) - pressure_behind(state)) / Rc_;
}

template <class Scalar>
Scalar Windkessel<Scalar>::energy(LocalState<Scalar> state) const
{
  const Scalar of_wall = 0.5 * C_ * state.y[0] * state.y[0];
  return has_inertance_ ? of_wall + 0.5 * L_ * state.y[1] * state.y[1] : of_wall;
}

template <class Scalar>
Exchange<Scalar> Windkessel<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                              const NodalCircuit<Scalar>& circuit) const
{
  const Scalar Q = flow(now, state, circuit);
  if (pressurises(now)) return {.inflow = -Q, .work = -circuit.pressure(node(0)) * Q};
  const Scalar through_Rc = has_inertance_ ? Q - state.y[1] : Q;
  const Scalar drop = state.y[0] - distal_pressure_, runoff = drop / Rp_;
  return {.inflow = -runoff,
          .work = -distal_pressure_ * runoff,
          .loss = drop * runoff + Rc_ * through_Rc * through_Rc};
}

template <class Scalar>
Scalar Windkessel<Scalar>::next_kink(double t) const
{
  return t + kTimeResolution_s < pressurise_s_ ? pressurise_s_
                                               : Scalar(std::numeric_limits<double>::infinity());
}

namespace {

ElementParameter positive(const std::string& name, const std::string& unit, const std::string& quantity,
                          double usual, const std::string& meaning)
{
  return {.name = name,
          .unit = unit,
          .quantity = quantity,
          .lowest = 0.0,
          .lowest_excluded = true,
          .usual = usual,
          .meaning = meaning};
}

ElementType common_type()
{
  return {
      .terminals = {"node"},
      .parameters = {{.name = "Rc_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a resistance",
                      .lowest = 0.0,
                      .usual = 0.033,
                      .meaning = "Characteristic resistance; 0 gives the two-element Windkessel"},
                     positive("Rp_mmHg_s_ml", "mmHg s/ml", "a peripheral resistance", 0.79,
                              "Peripheral resistance"),
                     positive("C_ml_mmHg", "ml/mmHg", "a compliance", 1.75, "Arterial compliance"),
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
      .factory = make_element<Windkessel, double>,
      .dual_factory = make_element<Windkessel, Dual>};
}

}  // namespace

ElementType windkessel3_type()
{
  ElementType type = common_type();
  type.name = "windkessel3";
  type.meaning = "Arterial tree: P = Pc + Rc Q, C dPc/dt = Q - (Pc - Pd)/Rp";
  return type;
}

ElementType windkessel4_type()
{
  ElementType type = common_type();
  type.name = "windkessel4";
  type.meaning = "Arterial tree with an inertance L beside Rc: P = Pc + Rc (Q - QL), L dQL/dt = Rc (Q - QL)";
  type.parameters.front() =
      positive("Rc_mmHg_s_ml", "mmHg s/ml", "a resistance", 0.056, "Characteristic resistance");
  type.parameters.insert(type.parameters.begin() + 3, positive("L_mmHg_s2_ml", "mmHg s^2/ml", "an inertance",
                                                               0.0051, "Total arterial inertance"));
  return type;
}

}  // namespace valsalva::lumped
