#include "run/lumped_loop.hpp"
#include "common/comm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/end_together.hpp"
#include "common/error.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/stop_signal.hpp"
#include "common/time_series.hpp"
#include "run/beats/beat_statistics.hpp"
#include "run/beats/periodic_beats.hpp"
#include "run/record.hpp"
#include "setup/aortic_valve.hpp"
#include "setup/periodic_start.hpp"
#include "setup/surrogate.hpp"

namespace valsalva::run {

namespace {

constexpr double kSampleInterval_s = 1e-3;

/// The number of an observable, -1 if there is none of this name.
int observable_number(const lumped::LumpedNetwork& network, const std::string& name)
{
  const auto& all = network.observables();
  const auto it = std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == name; });
  return it == all.end() ? -1 : static_cast<int>(it - all.begin());
}

}  // namespace

int run_lumped(const Case& c, const RunOptions& options, const Communicator& comm)
{
  if (!options.restart.empty())
    throw CaseError("", "a 0D run takes seconds and has no checkpoints; run it again with --force");
  const Timers timers;
  lumped::NetworkSpec given = setup::lumped_network(c);
  const setup::AorticValve aortic = setup::find_aortic_valve(given);
  if (!aortic.flow.empty()) given.integrals = {aortic.flow};
  given.balance = true;
  PeriodicBeats periodic(c.time.stop_when_periodic_within, c.time.beat_s());
  const setup::NetworkStart start = setup::network_start(c, given, comm);
  const lumped::NetworkSpec& spec = start.spec;
  const lumped::LumpedNetwork network(spec);
  common::create_output_folder(options.out_dir, options.force, c.source.resolved_toml(), comm);
  common::catch_stop_signals();
  Log log(comm.is_rank_0(), options.out_dir + "/log.txt");
  log.line(c.title);
  log.line(fmt::format("0D only: {} states, {} nodes, {} valves\n", network.state_count(),
                       network.node_count(), network.valve_count()));
  if (!start.text.empty()) log.line(start.text);

  const double end = c.time.end_s;
  lumped::LumpedState state = start.state;
  long steps = 0;
  bool stopped = false;
  const auto integrate = [&] {
    std::vector<std::string> names{"t_s"};
    for (const auto& q : network.observables()) names.push_back(q.name);
    for (const auto& s : network.states()) names.push_back(s.name);
    TimeSeriesWriter traces(options.out_dir + "/openings.csv", names);
    TimeSeriesWriter beats(options.out_dir + "/beats.csv", beat_columns());
    const int flow = observable_number(network, aortic.flow);
    const int p_ventricle = observable_number(network, aortic.p_ventricle);
    const int p_aorta = observable_number(network, aortic.p_aorta);
    TimeSeriesWriter switchings(options.out_dir + "/valves.csv", {"t_s", "open", "valve"});
    const std::vector<std::string> valve_names = network.valve_names();
    BeatStatistics statistics(spec.period_s);
    const auto record = [&] {
      const std::vector<double> seen = network.observe(state, {});
      std::vector<double> row{state.t};
      row.insert(row.end(), seen.begin(), seen.end());
      row.insert(row.end(), state.y.begin(), state.y.end());
      traces.add(row);
      const auto at = [&](int n) { return n < 0 ? 0.0 : seen[static_cast<std::size_t>(n)]; };
      statistics.add({state.t, at(flow), at(p_ventricle), at(p_aorta), -1, 0});
    };
    record();
    statistics.begin(balance_state(network, state));
    lumped::CvodeIntegrator integrator(network);
    while (state.t < end - 1e-12 && !stopped && !periodic.reached()) {
      const double stop = std::min(end, statistics.end_s());
      const double begin = state.t;
      const long rows = std::lround(std::ceil((stop - begin) / kSampleInterval_s));
      for (long n = 1; n <= rows && !stopped; ++n, ++steps) {
        integrator.advance(
            state,
            n == rows ? stop : begin + (stop - begin) * static_cast<double>(n) / static_cast<double>(rows),
            {}, {});
        for (const lumped::Switching& s : integrator.switchings())
          switchings.add({s.t, s.open ? 1.0 : 0.0}, valve_names[static_cast<std::size_t>(s.valve)]);
        record();
        stopped = common::stop_requested();
      }
      const BeatMetrics metrics = statistics.close(balance_state(network, state));
      if (flow >= 0) {
        beats.add(beat_row(metrics));
        log.line(beat_text(metrics) + "\n" + periodic.add(metrics));
      }
    }
    traces.flush();
    beats.flush();
    switchings.flush();
  };
  RunRecord record{options.case_path, "running", 0, 0, 0, 0, 0, 0};
  const auto update_record = [&] {
    record.t_s = state.t;
    record.wall_s = timers.wall();
    record.steps = steps;
  };
  const auto run_to_end = [&] {
    write_run_record(options.out_dir, record, comm);
    common::on_rank_0(comm, integrate);
    record.outcome = periodic.reached() ? periodic.outcome() : stopped ? "stopped by a signal" : "finished";
    log.line("results in " + options.out_dir);
    if (periodic.reached()) log.line(record.outcome);
    common::on_rank_0(comm, [&] { log.check(); });
    update_record();
    write_run_record(options.out_dir, record, comm);
  };
  common::note_failure(comm, run_to_end, [&] {
    update_record();
    write_failed_run_record(options.out_dir, record, comm);
  });
  return 0;
}

}  // namespace valsalva::run
