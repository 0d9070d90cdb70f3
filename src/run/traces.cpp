#include "run/traces.hpp"

#include <fmt/format.h>

#include "common/units.hpp"
#include "ib3d/output/probes.hpp"

namespace valsalva::run {

namespace {

bool forward_at(const ib3d::Opening& o)
{
  return ib3d::is_high(o.side);
}

/// Flow along +z from the outward flow of an opening.
double along_z(const ib3d::Opening& o, double outward)
{
  return forward_at(o) ? outward : -outward;
}

}  // namespace

Traces::Traces(const std::string& folder, const setup::Case& c, setup::CaseModel& model,
               const Communicator& comm)
    : folder_(folder),
      model_(model),
      comm_(comm),
      statistics_(c.time.beat_s()),
      every_(c.output.traces_every_steps),
      probes_z_(c.output.probes_z_cm),
      centre_{c.structure.root.centre[0], c.structure.root.centre[1]}
{
  if (c.structure.kind == setup::StructureKind::aortic_root) {
    const ib3d::RootDimensions& root = c.structure.root;
    valve_radius_ = root.annulus_radius;
    upstream_z_ = root.annulus_z - 0.5;
    downstream_z_ = root.sinus_end_z + 1.0;
    downstream_radius_ = root.ascending_radius;
  }
  for (const std::vector<int>& edge : model.structure().network.free_edges)
    edge_nodes_.insert(edge_nodes_.end(), edge.begin(), edge.end());

  steps_ = {"step",
            {"step", "t_s", "dt_s", "cfl", "iterations", "rms_divergence_1_s", "max_divergence_1_s", "wall_s",
             "dt_bound"},
            {}};
  openings_ = {"openings", {"t_s"}, {}};
  const std::vector<ib3d::Opening>& discs = model.solver().fluid().openings();
  for (const ib3d::Opening& o : discs) openings_.columns.push_back("p_" + o.port + "_mmHg");
  for (const ib3d::Opening& o : discs) openings_.columns.push_back("Q_" + o.name + "_ml_s");
  for (const auto& state : model.circulation().network().states()) openings_.columns.push_back(state.name);
  probes_ = {"probes", {"t_s"}, {}};
  for (double z : probes_z_) probes_.columns.push_back(fmt::format("p_z{:g}_mmHg", z));
  for (const char* name :
       {"Q_upstream_ml_s", "Q_valve_ml_s", "area_cm2", "fibre_strain_max", "tether_displacement_max_cm"})
    probes_.columns.emplace_back(name);
  beats_ = {"beats", beat_columns(), {}};
}

void Traces::begin()
{
  common::on_rank_0(comm_, [&] {
    for (File* file : {&steps_, &openings_, &probes_, &beats_})
      file->writer.emplace(path_of(*file), file->columns);
  });
  statistics_.add(sample());
  write_row({}, 0.0);
  statistics_.begin(balance_state(model_.model()));
}

void Traces::save_or_restore(Checkpoint& c)
{
  statistics_.save_or_restore(c);
  for (File* file : {&steps_, &openings_, &probes_, &beats_}) {
    std::int64_t position = 0;
    if (!c.reading()) common::on_rank_0(comm_, [&] { position = file->writer->position(); });
    c("traces/" + file->name + "_bytes", position);
    if (c.reading())
      common::on_rank_0(comm_, [&] {
        file->writer.emplace(TimeSeriesWriter::continue_at(path_of(*file), file->columns, position));
      });
  }
}

BeatSample Traces::sample() const
{
  const coupling::InterfaceState& now = model_.model().interface();
  const ib3d::ImmersedBoundarySolver& solver = model_.solver();
  const std::vector<ib3d::Opening>& discs = solver.fluid().openings();
  BeatSample sample;
  sample.t_s = now.t_s;
  if (!edge_nodes_.empty())
    sample.orifice_cm2 = ib3d::orifice_area(solver.nodes().gather(solver.X(), edge_nodes_));
  for (std::size_t m = 0; m < discs.size(); ++m) {
    sample.inflow_ml_s -= now.flow_ml_s[m];
    if (!forward_at(discs[m])) {
      sample.p_ventricle_mmHg = now.pressure_mmHg[m];
      continue;
    }
    sample.p_aorta_mmHg = now.pressure_mmHg[m];
    sample.flow_ml_s = now.flow_ml_s[m];
  }
  return sample;
}

std::vector<double> Traces::probe_row() const
{
  const ib3d::ImmersedBoundarySolver& solver = model_.solver();
  const ib3d::Hierarchy& grid = solver.fluid().grid();
  std::vector<double> row{model_.model().t()};
  const auto on_axis = [&](double z) { return Vec3{centre_[0], centre_[1], z}; };
  std::vector<Vec3> points;
  for (const double z : probes_z_) points.push_back(on_axis(z));
  for (double p : ib3d::pressure_at(grid, solver.fluid().p(), points))
    row.push_back(common::mmHg_from_dyn_cm2(p));
  const auto flow_at = [&](double z, double radius) {
    return radius > 0 ? ib3d::flow_through_disc(grid, solver.fluid().u(), 2, on_axis(z), radius) : 0.0;
  };
  const ib3d::Deformation deformed = solver.nodes().part().deformation(solver.X());
  const double upstream = flow_at(upstream_z_, valve_radius_);
  const double downstream = flow_at(downstream_z_, downstream_radius_);
  const double strain = comm_.max(deformed.largest_strain);
  const double displacement = comm_.max(deformed.largest_displacement);
  row.insert(row.end(), {upstream, downstream, statistics_.latest().orifice_cm2, strain, displacement});
  return row;
}

void Traces::write_row(const coupling::StepReport& step, double wall_s)
{
  const coupling::InterfaceState& now = model_.model().interface();
  const std::vector<ib3d::Opening>& discs = model_.solver().fluid().openings();
  const std::vector<double> probes = probe_row();

  std::vector<double> row{now.t_s};
  row.insert(row.end(), now.pressure_mmHg.begin(), now.pressure_mmHg.end());
  for (std::size_t m = 0; m < discs.size(); ++m) row.push_back(along_z(discs[m], now.flow_ml_s[m]));
  const std::vector<double>& y = model_.circulation().state().y;
  row.insert(row.end(), y.begin(), y.end());
  common::on_rank_0(comm_, [&] {
    openings_.writer->add(row);
    probes_.writer->add(probes);
    steps_.writer->add(
        {static_cast<double>(step.step), now.t_s, step.dt_s, step.cfl, static_cast<double>(step.iterations),
         step.divergence_rms, step.divergence_max, wall_s},
        ib3d::limit_name(step.limited_by));
  });
}

std::optional<BeatMetrics> Traces::record(const coupling::StepReport& step, double wall_s)
{
  const bool ends_beat = model_.model().t() > beat_end() - 1e-9;
  statistics_.add(sample());
  if (step.step % every_ == 0 || ends_beat) write_row(step, wall_s);
  if (!ends_beat) return std::nullopt;
  return close_beat();
}

BeatMetrics Traces::close_beat()
{
  const BeatMetrics metrics = statistics_.close(balance_state(model_.model()));
  common::on_rank_0(comm_, [&] { beats_.writer->add(beat_row(metrics)); });
  flush();
  return metrics;
}

std::optional<BeatMetrics> Traces::finish()
{
  if (statistics_.has_begun()) return close_beat();
  flush();
  return std::nullopt;
}

void Traces::flush()
{
  common::on_rank_0(comm_, [&] {
    for (File* file : {&steps_, &openings_, &probes_, &beats_}) file->writer->flush();
  });
}

}  // namespace valsalva::run
