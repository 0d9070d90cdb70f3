#include "lumped/chamber.hpp"

#include <fmt/format.h>

#include <cmath>

namespace valsalva::lumped {

Chamber::Chamber(std::string name, std::vector<int> nodes, ChamberParameters parameters,
                 Activation activation)
    : Element(std::move(name), std::move(nodes)), parameters_(parameters), activation_(activation)
{
}

std::vector<StateVariable> Chamber::states() const
{
  return {{"V_ml", "ml", parameters_.initial_volume}};
}

double Chamber::elastic_pressure(Instant now, double V) const
{
  const double onset = parameters_.period_s * std::floor(now.piece / parameters_.period_s);
  const double e = activation_.value(now.t - onset);
  return (parameters_.Emin + (parameters_.Emax - parameters_.Emin) * e) * (V - parameters_.V0);
}

void Chamber::connect(Instant now, LocalState state, NodalCircuit& circuit) const
{
  const double p = elastic_pressure(now, state.y[0]);
  if (parameters_.R > 0.0)
    circuit.add_pressure(node(0), p, parameters_.R);
  else
    circuit.hold_pressure(node(0), p);
}

void Chamber::rates(Instant now, LocalState state, const NodalCircuit& circuit, double* dydt) const
{
  dydt[0] = flow(now, state, circuit);
}

double Chamber::flow(Instant now, LocalState state, const NodalCircuit& circuit) const
{
  if (parameters_.R == 0.0) return circuit.flow_into_holder(node(0));
  return (circuit.pressure(node(0)) - elastic_pressure(now, state.y[0])) / parameters_.R;
}

double Chamber::next_kink(double t) const
{
  const double later = t + kTimeResolution_s;
  double onset = parameters_.period_s * std::floor(later / parameters_.period_s);
  if (onset > later) return onset;
  if (onset + activation_.kink() > later) return onset + activation_.kink();
  onset = parameters_.period_s * (std::floor(later / parameters_.period_s) + 1.0);
  return onset > later ? onset : onset + parameters_.period_s;
}

namespace {

double period_of(const ElementSpec& element, double case_period_s)
{
  const auto own = element.numbers.find("period_s");
  return own == element.numbers.end() ? case_period_s : own->second;
}

void check_chamber(const ElementSpec& element, double period_s, std::vector<CaseProblem>& problems)
{
  if (period_of(element, period_s) <= 0.0)
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

std::unique_ptr<Element> build_chamber(const ElementSpec& element, const std::vector<int>& nodes,
                                       double case_period_s)
{
  const auto number = [&](const char* key) { return element.numbers.at(key); };
  const double T = period_of(element, case_period_s);
  const Activation activation =
      element.words.at("activation") == "half_cosine"
          ? Activation::half_cosine(T * number("systole_periods"))
          : Activation::double_hill(
                {number("n1"), number("n2"), T * number("tau1_periods"), T * number("tau2_periods")}, T);
  return std::make_unique<Chamber>(
      element.name, nodes,
      ChamberParameters{number("Emax_mmHg_ml"), number("Emin_mmHg_ml"), number("V0_ml"),
                        number("initial_volume_ml"), T, number("R_mmHg_s_ml")},
      activation);
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
                     {.name = "R_mmHg_s_ml",
                      .unit = "mmHg s/ml",
                      .quantity = "a resistance",
                      .default_number = 0.0,
                      .lowest = 0.0,
                      .meaning = "Source resistance"}},
      .meaning = "Heart chamber: P = E(t)(V - V0) + R Q, dV/dt = Q",
      .factory = build_chamber,
      .check = check_chamber};
}

}  // namespace valsalva::lumped
