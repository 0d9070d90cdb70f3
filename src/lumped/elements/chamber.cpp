#include "lumped/elements/chamber.hpp"

#include <fmt/format.h>

#include <cmath>

namespace valsalva::lumped {

namespace {

template <class Scalar>
Scalar period_of(const ElementInput<Scalar>& input)
{
  return input.has("period_s") ? input.number("period_s") : Scalar(input.case_period_s());
}

template <class Scalar>
Activation<Scalar> activation_of(const ElementInput<Scalar>& input)
{
  const Scalar T = period_of(input);
  if (input.word("activation") == "half_cosine")
    return Activation<Scalar>::half_cosine(T * input.number("systole_periods"));
  return Activation<Scalar>::double_hill({input.number("n1"), input.number("n2"),
                                          T * input.number("tau1_periods"), T * input.number("tau2_periods")},
                                         T);
}

}  // namespace

template <class Scalar>
Chamber<Scalar>::Chamber(const ElementInput<Scalar>& input)
    : Element<Scalar>(input),
      Emax_(input.number("Emax_mmHg_ml")),
      Emin_(input.number("Emin_mmHg_ml")),
      V0_(input.number("V0_ml")),
      initial_volume_(input.number("initial_volume_ml")),
      R_(input.number("R_mmHg_s_ml")),
      period_s_(period_of(input)),
      onset_s_(period_s_ * input.number("onset_periods")),
      activation_(activation_of(input))
{
}

template <class Scalar>
std::vector<StateVariable<Scalar>> Chamber<Scalar>::states() const
{
  return {{"V_ml", "ml", initial_volume_}};
}

template <class Scalar>
Scalar Chamber<Scalar>::onset(double piece) const
{
  return onset_s_ + period_s_ * std::floor((piece - value_of(onset_s_)) / value_of(period_s_));
}

template <class Scalar>
const Scalar& Chamber<Scalar>::elastance(Instant now) const
{
  if (now.t != known_.at.t || now.piece != known_.at.piece)
    known_ = {now, Emin_ + (Emax_ - Emin_) * activation_.value(now.t - onset(now.piece))};
  return known_.E;
}

template <class Scalar>
Scalar Chamber<Scalar>::elastic_pressure(Instant now, const Scalar& V) const
{
  return elastance(now) * (V - V0_);
}

template <class Scalar>
void Chamber<Scalar>::connect(Instant now, LocalState<Scalar> state, NodalCircuit<Scalar>& circuit) const
{
  const Scalar p = elastic_pressure(now, state.y[0]);
  if (R_ > 0.0)
    circuit.add_pressure(node(0), p, R_);
  else
    circuit.hold_pressure(node(0), p);
}

template <class Scalar>
void Chamber<Scalar>::rates(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit,
                            Scalar* dydt) const
{
  dydt[0] = flow(now, state, circuit);
}

template <class Scalar>
Scalar Chamber<Scalar>::flow(Instant now, LocalState<Scalar> state, const NodalCircuit<Scalar>& circuit) const
{
  if (!(R_ > 0.0)) return circuit.flow_into_holder(node(0));
  return (circuit.pressure(node(0)) - elastic_pressure(now, state.y[0])) / R_;
}

template <class Scalar>
Exchange<Scalar> Chamber<Scalar>::exchange(Instant now, LocalState<Scalar> state,
                                           const NodalCircuit<Scalar>& circuit) const
{
  const Scalar Q = flow(now, state, circuit);
  return {.work = -elastic_pressure(now, state.y[0]) * Q, .loss = R_ * Q * Q};
}

template <class Scalar>
Scalar Chamber<Scalar>::next_kink(double t) const
{
  const double later = t + kTimeResolution_s;
  const Scalar begin = onset(later);
  for (const Scalar& kink : {begin, begin + activation_.kink(), begin + period_s_})
    if (kink > later) return kink;
  return begin + 2.0 * period_s_;
}

namespace {

void check_chamber(const ElementSpec& element, double period_s, std::vector<CaseProblem>& problems)
{
  if (!element.numbers.count("period_s") && period_s <= 0.0)
    problems.push_back(
        {"", 0, 0, element_key(element, "period_s"),
         "is missing, and the case names no heart period either; give one of the two, e.g. 0.8 s."});
  const double Emax = element.numbers.at("Emax_mmHg_ml"), Emin = element.numbers.at("Emin_mmHg_ml");
  if (Emax < Emin)
    problems.push_back(
        {"", 0, 0, element_key(element, "Emax_mmHg_ml"),
         fmt::format("is {} mmHg/ml, less than Emin_mmHg_ml = {}; the contracted chamber must be the "
                     "stiffer one. Swap the two?",
                     Emax, Emin)});
}

ElementParameter shape_parameter(const std::string& name, const std::string& quantity, double otherwise,
                                 double highest, const std::string& meaning)
{
  return {.name = name,
          .quantity = quantity,
          .default_number = otherwise,
          .lowest = 0.0,
          .highest = highest,
          .lowest_excluded = true,
          .meaning = meaning};
}

ElementParameter elastance(const std::string& name, double usual, const std::string& meaning)
{
  return {.name = name,
          .unit = "mmHg/ml",
          .quantity = "an elastance",
          .lowest = 0.0,
          .lowest_excluded = true,
          .usual = usual,
          .meaning = meaning};
}

}  // namespace

ElementType chamber_type()
{
  return {
      .name = "chamber",
      .terminals = {"node"},
      .parameters = {elastance("Emax_mmHg_ml", 2.4, "Elastance of the contracted chamber"),
                     elastance("Emin_mmHg_ml", 0.065, "Elastance of the relaxed chamber"),
                     {.name = "V0_ml",
                      .unit = "ml",
                      .quantity = "a volume",
                      .usual = 12.0,
                      .meaning = "Volume at zero pressure"},
                     {.name = "initial_volume_ml",
                      .unit = "ml",
                      .quantity = "a volume",
                      .lowest = 0.0,
                      .usual = 130.0,
                      .meaning = "Volume at the start"},
                     {.name = "period_s",
                      .unit = "s",
                      .quantity = "a period",
                      .required = false,
                      .lowest = 0.0,
                      .lowest_excluded = true,
                      .usual = 0.8,
                      .meaning = "Heart period; without it the case's time.period_s"},
                     {.name = "activation",
                      .kind = ParameterKind::word,
                      .quantity = "an activation",
                      .default_word = "double_hill",
                      .choices = {"double_hill", "half_cosine"},
                      .meaning = "Shape of the contraction in time"},
                     shape_parameter("n1", "an exponent", 1.32, 100.0,
                                     "Double Hill: exponent of contraction"),
                     shape_parameter("n2", "an exponent", 21.9, 100.0, "Double Hill: exponent of relaxation"),
                     shape_parameter("tau1_periods", "a fraction of the period", 0.303, 1.0,
                                     "Double Hill: time of contraction as a fraction of the period"),
                     shape_parameter("tau2_periods", "a fraction of the period", 0.508, 1.0,
                                     "Double Hill: time of relaxation as a fraction of the period"),
                     shape_parameter("systole_periods", "a fraction of the period", 0.4, 1.0,
                                     "Half cosine: length of the contraction as a fraction of the period"),
                     {.name = "onset_periods",
                      .quantity = "a fraction of the period",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .highest = 1.0,
                      .meaning = "When contraction sets in, as a fraction of the period (an atrium: 0.85)"},
                     {.name = "R_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a resistance",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .meaning = "Source resistance"}},
      .meaning = "Heart chamber: P = E(t)(V - V0) + R Q, dV/dt = Q",
      .factory = make_element<Chamber, double>,
      .dual_factory = make_element<Chamber, Dual>,
      .check = check_chamber};
}

}  // namespace valsalva::lumped
