#include "setup/keys_parts.hpp"

namespace valsalva::setup {

using namespace casefile;

KeySection fit_section()
{
  return {
      "fit",
      "What `valsalva fit` does",
      {text("data", "CSV with t_s and the measured columns, relative to the case; --data wins").or_else(""),
       flag("periodic", "The data are one beat of the periodic state; false: they begin at the initial state")
           .or_else(true)}};
}

std::vector<KeyArray> fit_arrays()
{
  return {{"fit_parameter",
           "A free parameter of `valsalva fit`; the search starts at the value of its element",
           {text("name", "Unique name of the entry"),
            text("parameter", "Number of an element, as arteries.Rp_mmHg_s_ml"),
            real("lowest", "", "Lower bound, in the parameter's unit").optional(),
            real("highest", "", "Upper bound, in the parameter's unit").optional()},
           {}},
          {"fit_signal",
           "A measured trace that `valsalva fit` compares with the network",
           {text("name", "Column of the data, as p_ao_mmHg"),
            text("observable", "Pressure p_<node>_mmHg or flow Q_<element>_ml_s of the network"),
            real("sd", "",
                 "Standard deviation of the measurement; without it, from the residuals (one signal only)")
                .above(0)
                .optional(),
            flag("baseline", "Fit a constant that the data have and the model has not").or_else(false),
            flag("shift", "Fit a time by which the data are early").or_else(false)},
           {}},
          {"fit_target",
           "A number read off the beat that `valsalva fit` compares with the network",
           {text("name", "Unique name of the target"),
            choice("kind", {"systolic", "diastolic", "mean", "volume"},
                   "Largest, smallest, mean value, or integral over the beat (stroke volume)"),
            text("observable", "Pressure p_<node>_mmHg or flow Q_<element>_ml_s of the network"),
            real("value", "", "Measured value, in mmHg, ml/s or ml"),
            real("sd", "", "Standard deviation of the measurement").above(0)},
           {}}};
}

}  // namespace valsalva::setup
