#include "setup/keys.hpp"

namespace valsalva::setup {

using namespace casefile;

std::vector<Section> output_sections()
{
  return {
      bound_section<Case, Output>(
          "output", "What is written, and how often", &Case::output,
          {{real("fields_every_s", "s", "Interval of velocity and pressure fields; 0: none").at_least(0),
            &Output::fields_every_s},
           {real("structure_every_s", "s", "Interval of the structure's shape; 0: none").at_least(0),
            &Output::structure_every_s},
           {integer("traces_every_steps", "Steps between two rows of the CSV traces").in(1, 1e6),
            &Output::traces_every_steps},
           {reals("probes_z_cm", "cm", "Heights on the centre line at which pressure is traced").at_least(0),
            &Output::probes_z_cm},
           {flag("pictures", "Draw pictures when the run has ended"), &Output::pictures},
           {flag("report", "Write report.html with the pictures"), &Output::report},
           {real("progress_every_s", "s", "Seconds of the wall clock between two lines of progress")
                .at_least(0),
            &Output::progress_every_s}}),
      bound_section<Case, Checkpoints>(
          "checkpoint",
          "From what a run can be continued (`valsalva run --restart latest`); one is always written at the "
          "end",
          &Case::checkpoints,
          {{real("every_wall_s", "s", "Seconds of the wall clock between two checkpoints; 0: only at the end")
                .at_least(0),
            &Checkpoints::every_wall_s},
           {integer("keep", "Number of checkpoints kept, the newest ones").in(1, 1000),
            &Checkpoints::keep}})};
}

}  // namespace valsalva::setup
