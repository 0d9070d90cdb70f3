#include "coupling/check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/comm.hpp"
#include "common/progress.hpp"
#include "coupling/coupled_run.hpp"
#include "coupling/periodic_beats.hpp"

namespace valsalva::coupling {

namespace {

constexpr int kTrialSteps = 6;

/// Bytes of fields per cell: three velocities, rates, forces (doubles, 4 sets of 3), pressures and Krylov
/// vectors.
constexpr double kBytesPerCell = 8 * (4 * 3 + 3 + 8) + 4 * 8;

}  // namespace

std::string describe_case(const CaseFile& c)
{
  const PeriodicBeats refused_without_a_period(c);
  if (is_lumped(c)) {
    const lumped::LumpedNetwork network(network_from_case(c));
    return fmt::format("0D only: {} states, {} nodes, {} valves", network.state_count(), network.node_count(),
                       network.valve_count());
  }
  Timers timers;
  const Communicator comm;
  CaseModel model(c, comm.raw(), timers);
  const StepControl control = step_control_from_case(c);
  std::string text = describe_model(c, model);
  const double end = c.section("time").real("end_s");
  double begun = 0, dt = 0;
  for (int n = 0; n < kTrialSteps; ++n) {
    if (n == 1) begun = timers.wall();  // the first step warms the caches up
    dt = model.model().advance(model.model().next_step(end)).dt_s;
  }
  const double per_step = (timers.wall() - begun) / (kTrialSteps - 1);
  const double steps = end / std::min(dt, control.dt_max_s);
  const double bytes = static_cast<double>(model.grid().valid_cell_count()) * kBytesPerCell;
  text += fmt::format("memory     about {:.0f} MB of fields\n", bytes / 1e6);
  text += fmt::format(
      "time       {:.0f} ms per step on {} rank{}; at the step of the start ({:.1e} s) {:.0f} steps, {}; "
      "fast flow makes steps shorter",
      1e3 * per_step, comm.size(), comm.size() == 1 ? "" : "s", dt, steps,
      common::duration_text(steps * per_step));
  return text;
}

}  // namespace valsalva::coupling
