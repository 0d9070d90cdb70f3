#include "run/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/progress.hpp"
#include "run/describe.hpp"
#include "run/memory_estimate.hpp"
#include "run/record.hpp"

namespace valsalva::run {

namespace {

constexpr int kTrialSteps = 8;

struct Trial {
  ib3d::StepBound bound;   ///< of the last step
  double wall_per_step_s;  ///< the median: one step that the machine disturbs does not count
};

Trial try_steps(setup::CaseModel& model, double end_s, const Timers& timers)
{
  Trial trial{};
  std::vector<double> wall;
  for (int n = 0; n < kTrialSteps && model.model().t() < end_s; ++n) {
    const double begun = timers.wall();
    trial.bound = model.model().next_step(end_s);
    model.model().advance(trial.bound);
    wall.push_back(timers.wall() - begun);
  }
  if (wall.empty()) return trial;
  std::nth_element(wall.begin(), wall.begin() + std::ssize(wall) / 2, wall.end());
  trial.wall_per_step_s = wall[wall.size() / 2];
  return trial;
}

std::string memory_lines(setup::CaseModel& model, const Communicator& comm)
{
  const MemoryEstimate m = estimate_memory(model, comm);
  std::string text =
      fmt::format("memory     about {:.0f} MB: fields with ghosts {:.0f}, structure {:.0f}, program {:.0f}",
                  m.total_mb(), m.fields_mb, m.structure_mb, m.program_mb);
  if (m.regrid_mb > 0) text += fmt::format(", while the grid changes {:.0f} more", m.regrid_mb);
  return text + fmt::format("; the trial steps took {:.0f} MB\n", peak_memory_mb(comm));
}

/// Which bound holds at rest, and the speed beyond which the flow shortens the steps.
std::string step_line(const setup::CaseModel& model, const coupling::StepControl& control,
                      const ib3d::StepBound& bound)
{
  std::string text = fmt::format("step       {:.2e} s at the start, limited by {}", bound.dt,
                                 ib3d::limit_name(bound.limited_by));
  if (control.dt_fixed_s == 0)
    text += fmt::format("; flow shortens it where |u| + |v| + |w| exceeds {:.0f} cm/s",
                        control.cfl * model.grid().finest().h / bound.dt);
  return text + "\n";
}

}  // namespace

std::string describe_case(const setup::Case& c, const Communicator& comm)
{
  if (c.is_lumped()) {
    const lumped::LumpedNetwork network(c.network);
    return fmt::format("0D only: {} states, {} nodes, {} valves", network.state_count(), network.node_count(),
                       network.valve_count());
  }
  Timers timers;
  setup::CaseModel model(c, comm, timers);
  std::string text = describe_model(c, model);
  const double end = c.time.end_s;
  const Trial trial = try_steps(model, end, timers);
  const double steps = end / trial.bound.dt;
  text += step_line(model, c.time.steps, trial.bound);
  text += memory_lines(model, comm);
  text +=
      fmt::format("time       {:.0f} ms per step on {} rank{}: {:.0f} steps to t = {:g} s, {} without output",
                  1e3 * trial.wall_per_step_s, comm.size(), comm.size() == 1 ? "" : "s", std::ceil(steps),
                  end, common::duration_text(steps * trial.wall_per_step_s));
  return text;
}

}  // namespace valsalva::run
