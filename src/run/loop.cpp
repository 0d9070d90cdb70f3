#include "run/loop.hpp"
#include "common/comm.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "common/end_together.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/progress.hpp"
#include "common/stop_signal.hpp"
#include "run/beats/periodic_beats.hpp"
#include "run/checkpoints.hpp"
#include "run/record.hpp"
#include "run/snapshots.hpp"
#include "run/traces.hpp"

namespace valsalva::run {

namespace {

/// Tells where the run is: a line every few seconds, and a live bar in between where the output is a terminal.
class ProgressLines {
 public:
  ProgressLines(Log& log, const coupling::CoupledModel& now, double end_s, double every_s, double wall_s)
      : log_(log),
        begin_s_(now.t()),
        end_s_(end_s),
        every_s_(every_s),
        begun_(wall_s),
        told_(wall_s),
        shown_(wall_s),
        told_step_(now.step())
  {
  }

  void tell(const coupling::StepReport& s, const Traces& traces, double wall_s)
  {
    const double done = s.t_s / end_s_;
    const std::string eta = common::eta_text((s.t_s - begin_s_) / (end_s_ - begin_s_), wall_s - begun_);
    if (wall_s - told_ > every_s_) {
      const BeatSample& now = traces.latest();
      log_.line(fmt::format(
          "step {:>6}  t {:.4f} s (beat {})  dt {:.1e} ({})  CFL {:.2f}  p_lv {:.1f} p_ao {:.1f} mmHg  "
          "Q {:.0f} ml/s  {:.0f} ms/step  ETA {}",
          s.step, s.t_s, traces.beat(), s.dt_s, ib3d::limit_name(s.limited_by), s.cfl, now.p_ventricle_mmHg,
          now.p_aorta_mmHg, now.flow_ml_s, 1e3 * (wall_s - told_) / static_cast<double>(s.step - told_step_),
          eta));
      told_ = wall_s;
      told_step_ = s.step;
    } else if (wall_s - shown_ > 0.2) {
      log_.live(
          fmt::format("{} t {:.4f} of {:g} s  ETA {}", common::progress_bar(done, 40), s.t_s, end_s_, eta));
      shown_ = wall_s;
    }
  }

 private:
  Log& log_;
  double begin_s_, end_s_, every_s_, begun_, told_, shown_;
  long told_step_;
};

/// Adds to a numerical failure where it happened and what is safe.
[[noreturn]] void fail_at(const coupling::CoupledModel& model, const std::string& folder,
                          const std::string& checkpoint, const SolverError& error)
{
  throw SolverError(fmt::format("step {}, t = {:.6g} s: {}. All output up to this time is in {}{}{}",
                                model.step() + 1, model.t(), error.what(), folder,
                                checkpoint.empty() ? "" : "; the last checkpoint is ", checkpoint));
}

/// The domain's inertance at each Windkessel, and how far explicit coupling would be from its limit dt* there
/// (docs/scheme.md, section 4).
std::string describe_coupling(const CaseFile& c, setup::CaseModel& m)
{
  const lumped::NetworkSpec spec = setup::network_from_case(c);
  std::string text;
  for (std::size_t port = 0; port < spec.ports.size(); ++port) {
    const double L = m.model().inertance(static_cast<int>(port));
    for (const CaseTable& e : c.tables("element")) {
      if (!e.text("type").starts_with("windkessel") || e.text("node") != spec.ports[port]) continue;
      const double C = e.real("C_ml_mmHg"), R = e.real("Rc_mmHg_s_ml");
      const double limit = C * (-R + std::sqrt(R * R + 4 * L / C));
      text += fmt::format(
          "coupling   {}: inertance {:.4g} mmHg s^2/ml; explicit coupling would need dt < dt* = {:.3g} s "
          "(longest dt/dt* = {:.2g})\n",
          e.text("name"), L, limit, c.section("time").real("dt_max_s") / limit);
    }
  }
  return text;
}

}  // namespace

std::string describe_model(const CaseFile& c, setup::CaseModel& m)
{
  std::string text;
  for (const ib3d::Level& level : m.grid().levels())
    text += fmt::format(
        "grid       {} cells of {:.5g} cm in {} box{}{}\n", level.cell_count(), level.h, level.patches.size(),
        level.patches.size() == 1 ? "" : "es",
        level.cell_count() == level.box.volume()
            ? fmt::format(", {} x {} x {}", level.box.size(0), level.box.size(1), level.box.size(2))
            : std::string());
  const ib3d::FibreNetwork& n = m.structure().network;
  text += fmt::format("structure  {} nodes, {} springs, {} beams, {} tethers\n", n.node_count(),
                      n.springs.count(), n.beams.count(), n.tethers.count());
  if (m.structure().is_root) {
    std::array<std::string, 3> lines;
    for (std::size_t leaflet = 0; leaflet < 3; ++leaflet) {
      const ib3d::LeafletShape& s = m.structure().closed[leaflet];
      lines[leaflet] = fmt::format(
          "closed under {:.0f} mmHg: strain {:.3f} mean, {:.3f} largest; tension {:.2g} mean, {:.2g} largest "
          "dyn/cm; coaptation {:.2f} cm\n",
          s.pressure_mmHg, s.circumferential_strain_mean, s.circumferential_strain_max, s.tension_mean,
          s.tension_max, s.coaptation_height_cm);
    }
    if (lines[0] == lines[1] && lines[1] == lines[2])
      text += "leaflets   " + lines[0];
    else
      for (std::size_t leaflet = 0; leaflet < 3; ++leaflet)
        text += fmt::format("leaflet {}  {}", leaflet + 1, lines[leaflet]);
  }
  const double omega = m.root().elastic_rate();
  if (omega > 0) {
    const coupling::StepControl control = setup::step_control_from_case(c);
    const double share = control.dt_fixed_s > 0 ? 0.5 * omega * control.dt_fixed_s : control.elastic_safety;
    text +=
        fmt::format("step       elastic bound {:.2e} s at the start (2/omega_max; {:.0f} % of it is used)\n",
                    2 / omega, 100 * share);
  }
  if (!m.start().text.empty()) text += m.start().text + '\n';
  std::size_t markers = 0;
  for (const ib3d::MarkerSeed& seed : m.root().markers().seeds()) markers += seed.points.size();
  if (markers > 0)
    text += fmt::format("markers    {} each time they set out, in {} groups\n", markers,
                        m.root().markers().seeds().size());
  return text + describe_coupling(c, m);
}

int run_coupled(const CaseFile& c, const RunOptions& options)
{
  const Communicator comm;
  Timers timers;
  PeriodicBeats beats(c);
  std::optional<Restart> restart = find_restart(options.restart, options.out_dir, options.force, c, comm);
  setup::CaseModel model(c, comm.raw(), timers);
  if (restart)
    common::continue_output_folder(options.out_dir, c.resolved_toml(), comm);
  else
    common::create_output_folder(options.out_dir, options.force, c.resolved_toml(), comm);
  Log log(comm.is_rank_0(), options.out_dir + "/log.txt", restart.has_value());
  common::catch_stop_signals();
  log.line(c.section("").text("title"));
  log.line(fmt::format("ranks      {}", comm.size()));
  log.line(describe_model(c, model));

  const double end = c.section("time").real("end_s");
  coupling::CoupledModel& coupled = model.model();
  Traces traces(options.out_dir, c, model, comm);
  Snapshots snapshots(options.out_dir, c, model, comm);
  double wall_before = 0;  // of the runs that this one continues
  RunCheckpoints checkpoints(
      options.out_dir, c, comm, timers.wall(),
      [&](Checkpoint& file) {
        double wall = wall_before + timers.wall();
        file("wall_s", wall);
        if (file.reading()) wall_before = wall;
        coupled.save_or_restore(file);
        if (coupled.t() > end + 1e-9)
          throw CaseError({c.section("time").problem(
              "end_s",
              fmt::format("lies before t = {:.6g} s of {}; use a later end", coupled.t(), file.path()))});
      },
      [&](Checkpoint& file) {
        traces.save_or_restore(file);
        beats.save_or_restore(file);
        snapshots.save_or_restore(file);
      });
  if (restart) {
    for (const std::string& why : restart->unreadable) log.warning("passed over " + why);
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
  ProgressLines progress(log, coupled, end, c.section("output").real("progress_every_s"), timers.wall());
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
        progress.tell(step, traces, timers.wall());
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
    if (const ib3d::Markers& markers = model.root().markers(); markers.lost() > 0)
      log.line(fmt::format("{} of {} markers have left the domain", markers.lost(), markers.set_out()));
    if (stopped)
      log.line(fmt::format("stopped at t = {:.4f} s by a signal; all output is complete up to there",
                           coupled.t()));
    log.line("results in " + options.out_dir);
    const char* go_on = beats.reached() ? "to go on with a smaller time.stop_when_periodic_within:"
                        : stopped       ? "to continue:"
                                        : "to go on with a later time.end_s:";
    log.line(fmt::format("checkpoint {}\n{} {}", checkpoints.last(), go_on, options.continue_command));
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
