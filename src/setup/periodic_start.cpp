#include "setup/periodic_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "lumped/integration/limit_cycle.hpp"
#include "setup/aortic_valve.hpp"
#include "setup/surrogate.hpp"

namespace valsalva::setup {

namespace {

constexpr double kRestingFlow =
    0.05;  ///< of the peak flow; less than this the fluid of a 3D run may start without
constexpr int kFlowSamples = 400;

lumped::NetworkSpec past_start_up(lumped::NetworkSpec spec)
{
  for (lumped::ElementSpec& e : spec.elements)
    if (const auto ramp = e.numbers.find("pressurise_s"); ramp != e.numbers.end()) ramp->second = 0.0;
  return spec;
}

/// `to` with every state and valve that `from` has as well, at t = 0.
lumped::LumpedState taken_over(const lumped::LumpedNetwork& from, const lumped::LumpedState& state,
                               const lumped::LumpedNetwork& to)
{
  lumped::LumpedState taken = to.initial_state();
  for (std::size_t i = 0; i < taken.y.size(); ++i)
    for (std::size_t k = 0; k < state.y.size(); ++k)
      if (to.states()[i].name == from.states()[k].name) taken.y[i] = state.y[k];
  const std::vector<std::string> valves = to.valve_names(), known = from.valve_names();
  for (std::size_t i = 0; i < valves.size(); ++i)
    for (std::size_t k = 0; k < known.size(); ++k)
      if (valves[i] == known[k]) taken.valve_open[i] = state.valve_open[k];
  return taken;
}

/// `spec` is past its start-up.
NetworkStart periodic_start(const Case& c, const lumped::NetworkSpec& spec)
{
  const lumped::NetworkSpec twin = past_start_up(lumped_network(c));
  const lumped::LimitCycle cycle = lumped::find_limit_cycle(twin);
  NetworkStart start{spec, taken_over(lumped::LumpedNetwork(twin), cycle.start, lumped::LumpedNetwork(spec)),
                     0.0, ""};
  start.text = fmt::format("start      from the periodic 0D state, found in {} Newton step{}",
                           cycle.newton_steps, cycle.newton_steps == 1 ? "" : "s");

  const AorticValve aortic = find_aortic_valve(twin);
  if (aortic.flow.empty()) return start;
  std::vector<double> times;
  for (int n = 0; n < kFlowSamples; ++n) times.push_back(twin.period_s * n / kFlowSamples);
  const lumped::SampledBeat beat =
      lumped::sample_beat(twin, cycle, {}, {aortic.flow, aortic.p_ventricle, aortic.p_aorta}, times);
  const double flow = beat.values(0, 0), peak = beat.values.col(0).maxCoeff<Eigen::PropagateNaN>();
  if (!spec.ports.empty() && !(std::abs(flow) <= kRestingFlow * peak))
    throw CaseError(
        "time.start",
        fmt::format("is \"periodic\", but {:.3g} ml/s pass the root when the beat begins (peak {:.3g}) "
                    "and the fluid starts at rest; shift the sources so that t = 0 is in diastole",
                    flow, peak));
  start.valve_load_mmHg = beat.values(0, 2) - beat.values(0, 1);
  start.text += fmt::format("; stroke volume there {:.1f} ml, load of the valve {:.1f} mmHg",
                            beat.integrals[0], start.valve_load_mmHg);
  return start;
}

}  // namespace

NetworkStart network_start(const Case& c, lumped::NetworkSpec spec, const Communicator& comm)
{
  const bool at_rest = c.time.start == Start::rest;
  if (!at_rest) spec = past_start_up(std::move(spec));
  NetworkStart start{spec, lumped::LumpedNetwork(spec).initial_state(), 0.0, ""};
  if (at_rest) return start;
  std::vector<double> load{0.0};
  const auto find = [&] {
    start = periodic_start(c, spec);
    load = {start.valve_load_mmHg};
  };
  common::on_rank_0(comm, find, load);
  start.valve_load_mmHg = load[0];
  return start;
}

}  // namespace valsalva::setup
