#include "run/loop.hpp"

#include <fmt/format.h>

#include "common/end_together.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/stop_signal.hpp"
#include "run/beats/periodic_beats.hpp"
#include "run/checkpoints.hpp"
#include "run/describe.hpp"
#include "run/progress.hpp"
#include "run/record.hpp"
#include "run/snapshots.hpp"
#include "run/traces.hpp"

namespace valsalva::run {

namespace {

/// Adds to a numerical failure where it happened and what is safe.
[[noreturn]] void fail_at(const coupling::CoupledModel& model, const std::string& folder,
                          const std::string& checkpoint, const SolverError& error)
{
  throw SolverError(fmt::format("step {}, t = {:.6g} s: {}. All output up to this time is in {}{}{}",
                                model.step() + 1, model.t(), error.what(), folder,
                                checkpoint.empty() ? "" : "; the last checkpoint is ", checkpoint));
}

}  // namespace

int run_coupled(const Case& c, const RunOptions& options, const Communicator& comm)
{
  Timers timers;
  PeriodicBeats beats(c.time.stop_when_periodic_within, c.time.beat_s());
  std::optional<Restart> restart = find_restart(options.restart, options.out_dir, options.force, c, comm);
  setup::CaseModel model(c, comm, timers);
  if (restart)
    common::continue_output_folder(options.out_dir, c.source.resolved_toml(), comm);
  else
    common::create_output_folder(options.out_dir, options.force, c.source.resolved_toml(), comm);
  Log log(comm.is_rank_0(), options.out_dir + "/log.txt", restart.has_value());
  common::catch_stop_signals();
  log.line(c.title);
  log.line(fmt::format("ranks      {}", comm.size()));
  log.line(describe_model(c, model));

  const double end = c.time.end_s;
  coupling::CoupledModel& coupled = model.model();
  Traces traces(options.out_dir, c, model, comm);
  Snapshots snapshots(options.out_dir, c.output, model, comm);
  double wall_before = 0;  // of the runs that this one continues
  RunCheckpoints checkpoints(
      options.out_dir, c, comm, timers.wall(),
      [&](Checkpoint& file) {
        double wall = wall_before + timers.wall();
        file("wall_s", wall);
        if (file.reading()) wall_before = wall;
        coupled.save_or_restore(file);
        if (coupled.t() > end + 1e-9)
          throw CaseError("time.end_s", fmt::format("lies before t = {:.6g} s of {}; use a later end",
                                                    coupled.t(), file.path()));
      },
      [&](Checkpoint& file) {
        traces.save_or_restore(file);
        beats.save_or_restore(file);
        snapshots.save_or_restore(file);
      });
  if (restart) {
    for (const std::string& why : restart->unreadable) log.warning("skipped " + why);
    checkpoints.restore(restart->file);
    log.line(fmt::format("continued  from {}: step {}, t = {:.6g} s", restart->file.path(), coupled.step(),
                         coupled.t()));
    restart.reset();
  } else {
    traces.begin();
  }

  RunRecord record{options.case_path,
                   "",
                   0,
                   0,
                   0,
                   0,
                   model.grid().valid_cell_count(),
                   model.structure().network.node_count()};
  const auto update_record = [&] {
    record.t_s = coupled.t();
    record.steps = coupled.step();
    record.cells = model.grid().valid_cell_count();
    record.wall_s = wall_before + timers.wall();
  };
  const auto write_record = [&](const std::string& outcome) {
    record.outcome = outcome;
    update_record();
    write_run_record(options.out_dir, record, comm);
  };
  const auto tell_beat = [&](const BeatMetrics& beat) { log.line(beat_text(beat) + "\n" + beats.add(beat)); };
  const auto write_checkpoint = [&] {
    const auto scope = timers.time("checkpoint");
    checkpoints.write(coupled.step(), timers.wall());
  };
  ProgressLines progress(log, coupled, end, c.output.progress_every_s, timers.wall());
  const auto run_to_end = [&] {
    bool stopped = false;
    write_record("running");
    try {
      snapshots.write_due();
      while (coupled.t() < end - 1e-12 && !stopped && !beats.reached()) {
        const double step_begun = timers.wall();
        const coupling::StepReport step =
            coupled.advance(coupled.next_step(std::min({end, snapshots.next_time(), traces.beat_end()})));
        {
          const auto scope = timers.time("output");
          if (const auto beat = traces.record(step, timers.wall() - step_begun)) tell_beat(*beat);
          snapshots.write_due();
        }
        progress.tell(step, traces.latest(), traces.beat(), timers.wall());
        common::on_rank_0(comm, [&] { log.check(); });
        stopped = comm.any(common::stop_requested());
        if (comm.any(checkpoints.due(timers.wall()))) write_checkpoint();
      }
    } catch (const SolverError& error) {
      fail_at(coupled, options.out_dir, checkpoints.last(), error);
    }
    write_checkpoint();
    if (const auto beat = traces.finish()) tell_beat(*beat);
    log.line(timers.table());
    if (const ib3d::Markers& markers = model.solver().markers(); markers.lost() > 0)
      log.line(fmt::format("{} of {} markers left the domain", markers.lost(), markers.set_out()));
    if (stopped)
      log.line(fmt::format("stopped at t = {:.4f} s by a signal; all output is complete up to there",
                           coupled.t()));
    log.line("results in " + options.out_dir);
    const char* purpose = beats.reached() ? "to continue with a smaller time.stop_when_periodic_within:"
                          : stopped       ? "to continue:"
                                          : "to continue with a later time.end_s:";
    log.line(fmt::format("checkpoint {}\n{} {}", checkpoints.last(), purpose, options.continue_command));
    if (beats.reached()) log.line(beats.outcome());
    common::on_rank_0(comm, [&] { log.check(); });
    write_record(beats.reached() ? beats.outcome() : stopped ? "stopped by a signal" : "finished");
  };
  common::note_failure(comm, run_to_end, [&] {
    update_record();
    write_failed_run_record(options.out_dir, record, comm);
  });
  return 0;
}

}  // namespace valsalva::run
