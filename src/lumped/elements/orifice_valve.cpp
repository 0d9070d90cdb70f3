#include "lumped/elements/orifice_valve.hpp"

#include <fmt/format.h>

#include "common/units.hpp"

namespace valsalva::lumped {

namespace {
constexpr double kBand = 1e-10;  // mmHg; a grazing pressure drop does not make it chatter
}

template <class Scalar>
OrificeValve<Scalar>::OrificeValve(const ElementInput<Scalar>& input)
    : Element<Scalar>(input),
      area_open_(input.number("area_open_cm2")),
      area_closed_(input.number("area_closed_cm2")),
      length_(input.number("length_cm")),
      opening_(input.number("opening_1_mmHg_s")),
      closing_(input.number("closing_1_mmHg_s")),
      R_(input.number("R_mmHg_s_ml")),
      L_(input.number("L_mmHg_s2_ml")),
      density_(input.number("density_g_cm3") * common::mmHg_from_dyn_cm2(1.0))
{
}

template <class Scalar>
std::vector<StateVariable<Scalar>> OrificeValve<Scalar>::states() const
{
  return {{"Q_ml_s", "ml/s", 0.0}, {"zeta", "", 0.0}};
}

template <class Scalar>
void OrificeValve<Scalar>::connect(Instant, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const
{
  circuit.add_flow(node(0), node(1), state.y[0]);
}

template <class Scalar>
Branch<Scalar> OrificeValve<Scalar>::branch_at(const Scalar& area) const
{
  return {R_, L_ + density_ * length_ / area, 0.5 * density_ / (area * area)};
}

template <class Scalar>
Scalar OrificeValve<Scalar>::opening_rate(LocalState<Scalar> state, const Scalar& dv) const
{
  const Scalar& zeta = state.y[1];
  return state.open ? (1.0 - zeta) * opening_ * dv : zeta * closing_ * dv;
}

template <class Scalar>
Scalar OrificeValve<Scalar>::drop_at_leaflets(LocalState<Scalar> state,
                                              const NodalCircuit<Scalar>& circuit) const
{
  const Scalar dp = pressure_drop(circuit);
  return dp - L_ * branch_at(area(state)).rate(dp, state.y[0]);
}

template <class Scalar>
void OrificeValve<Scalar>::rates(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
                                 Scalar* dydt) const
{
  const Scalar dp = pressure_drop(circuit);
  dydt[0] = branch_at(area(state)).rate(dp, state.y[0]);
  dydt[1] = opening_rate(state, dp - L_ * dydt[0]);
}

template <class Scalar>
Scalar OrificeValve<Scalar>::flow(Instant, LocalState<Scalar> state, const NodalCircuit<Scalar>&) const
{
  return state.y[0];
}

template <class Scalar>
Scalar OrificeValve<Scalar>::energy(LocalState<Scalar> state) const
{
  return branch_at(area(state)).energy(state.y);
}

template <class Scalar>
Exchange<Scalar> OrificeValve<Scalar>::exchange(Instant, LocalState<Scalar> state,
                                                const NodalCircuit<Scalar>& circuit) const
{
  // The inertance rho l/A changes with the orifice; the Q^2/2 dL/dt that this takes or gives counts as loss.
  const Scalar A = area(state), &Q = state.y[0];
  const Scalar area_rate =
      (area_open_ - area_closed_) * opening_rate(state, drop_at_leaflets(state, circuit));
  const Branch<Scalar> branch = branch_at(A);
  return {.loss = branch.loss(Q) + 0.5 * Q * Q * (branch.L - L_) * area_rate / A};
}

template <class Scalar>
Scalar OrificeValve<Scalar>::switch_margin(LocalState<Scalar> state,
                                           const NodalCircuit<Scalar>& circuit) const
{
  const Scalar dv = drop_at_leaflets(state, circuit);
  return kBand + (state.open ? dv : -dv);
}

namespace {

ElementParameter positive(const std::string& name, const std::string& unit, const std::string& quantity,
                          std::optional<double> otherwise, double usual, const std::string& meaning)
{
  return {.name = name,
          .unit = unit,
          .quantity = quantity,
          .default_number = otherwise,
          .lowest = 0.0,
          .lowest_excluded = true,
          .usual = usual,
          .meaning = meaning};
}

void check_areas(const ElementSpec& e, double, std::vector<CaseProblem>& problems)
{
  const double open = e.numbers.at("area_open_cm2"), closed = e.numbers.at("area_closed_cm2");
  if (closed >= open)
    problems.push_back(
        {"", 0, 0, element_key(e, "area_closed_cm2"),
         fmt::format("is {} cm^2, not less than area_open_cm2 = {}; swap the two?", closed, open)});
}

}  // namespace

ElementType orifice_valve_type()
{
  return {
      .name = "orifice_valve",
      .terminals = {"from", "to"},
      .parameters = {positive("area_open_cm2", "cm^2", "an area", {}, 4.0, "Orifice of the open valve"),
                     positive("area_closed_cm2", "cm^2", "an area", 1e-4, 1e-4,
                              "Orifice of the closed valve, through which it leaks"),
                     positive("length_cm", "cm", "a length", 1.0, 1.0, "Length of the accelerated blood"),
                     positive("opening_1_mmHg_s", "1/mmHg/s", "a rate", 20.0, 20.0,
                              "Opening rate of the leaflets per mmHg"),
                     positive("closing_1_mmHg_s", "1/mmHg/s", "a rate", 20.0, 20.0,
                              "Closing rate of the leaflets per mmHg"),
                     {.name = "R_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a resistance",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .meaning = "Viscous resistance"},
                     {.name = "L_mmHg_s2_ml",
                      .unit = "mmHg s^2/ml",
                      .quantity = "an inertance",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .meaning =
                          "Inertance of vessels in series, whose pressure drop does not move the leaflets"},
                     positive("density_g_cm3", "g/cm^3", "a density", 1.06, 1.06, "Density of the blood")},
      .meaning = "Valve with leaflets that need time: orifice area A(zeta), Bernoulli loss rho Q|Q|/(2 A^2)",
      .factory = make_element<OrificeValve, double>,
      .dual_factory = make_element<OrificeValve, Dual>,
      .check = check_areas};
}

}  // namespace valsalva::lumped
