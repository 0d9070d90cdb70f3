#include "setup/keys.hpp"

namespace valsalva::setup {

using namespace casefile;

namespace {

constexpr const char* kObservable = "Pressure p_<node>_mmHg or flow Q_<element>_ml_s of the network";

Array parameter_array()
{
  using lumped::FitParameter;
  using Key = BoundKey<FitParameter>;
  return bound_array<Case, FitParameter>(
      "fit_parameter", "A free parameter of `valsalva fit`; the search starts at the value of its element",
      at(&Case::fit, &Fit::parameters),
      {Key(text("name", "Unique name of the entry")),
       Key(text("parameter", "Number of an element, as arteries.Rp_mmHg_s_ml"), &FitParameter::name).needed(),
       {real("lowest", "", "Lower bound, in the parameter's unit"), &FitParameter::lowest},
       {real("highest", "", "Upper bound, in the parameter's unit"), &FitParameter::highest}});
}

Array signal_array()
{
  using Key = BoundKey<FitSignal>;
  return bound_array<Case, FitSignal>(
      "fit_signal", "A measured trace that `valsalva fit` compares with the network",
      at(&Case::fit, &Fit::signals),
      {Key(text("name", "Column of the data, as p_ao_mmHg"), &FitSignal::column).needed(),
       Key(text("observable", kObservable), &FitSignal::observable).needed(),
       {real("sd", "",
             "Standard deviation of the measurement; without it, from the residuals (one signal only)")
            .above(0),
        &FitSignal::sd},
       {flag("baseline", "Fit a constant offset that the data contain and the model does not"),
        &FitSignal::baseline},
       {flag("shift", "Fit a time by which the data are early"), &FitSignal::shift}});
}

Array target_array()
{
  using lumped::FitSummary, lumped::SummaryKind;
  using Key = BoundKey<FitSummary>;
  return bound_array<Case, FitSummary>(
      "fit_target", "A number read off the beat that `valsalva fit` compares with the network",
      at(&Case::fit, &Fit::targets),
      {Key(text("name", "Unique name of the target"), &FitSummary::name).needed(),
       Key(choice("kind", {"systolic", "diastolic", "mean", "volume"},
                  "Largest, smallest, mean value, or integral over the beat (stroke volume)"),
           &FitSummary::kind,
           std::vector{SummaryKind::systolic, SummaryKind::diastolic, SummaryKind::mean, SummaryKind::volume})
           .needed(),
       Key(text("observable", kObservable), &FitSummary::observable).needed(),
       Key(real("value", "", "Measured value, in mmHg, ml/s or ml"), &FitSummary::value).needed(),
       Key(real("sd", "", "Standard deviation of the measurement").above(0), &FitSummary::sd).needed()});
}

}  // namespace

Section fit_section()
{
  return bound_section<Case, Fit>(
      "fit", "What `valsalva fit` does", &Case::fit,
      {{text("data", "CSV with t_s and the measured columns, relative to the case; --data wins"), &Fit::data},
       {flag("periodic",
             "The data are one beat of the periodic state; false: they begin at the initial state"),
        &Fit::periodic}});
}

std::vector<Array> fit_arrays()
{
  return {parameter_array(), signal_array(), target_array()};
}

}  // namespace valsalva::setup
