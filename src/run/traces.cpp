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

Traces::Traces(const std::string& folder, const CaseFile& c, setup::CaseModel& model,
               const Communicator& comm)
    : folder_(folder),
      model_(model),
      comm_(comm),
      books_(setup::beat_length(c)),
      every_(c.section("output").integer("traces_every_steps")),
      probes_z_(c.section("output").reals("probes_z_cm")),
      centre_(c.section("root").reals("center_cm"))
{
  if (model.structure().is_root) {
    const CaseTable& root = c.section("root");
    valve_radius_ = root.real("annulus_radius_cm");
    upstream_z_ = root.real("annulus_z_cm") - 0.5;
    downstream_z_ = root.real("sinus_end_z_cm") + 1.0;
    downstream_radius_ = root.real("ascending_radius_cm");
  }
  for (const std::vector<int>& edge : model.structure().network.free_edges)
    edge_nodes_.insert(edge_nodes_.end(), edge.begin(), edge.end());

  steps_ = {"step",
            {"step", "t_s", "dt_s", "cfl", "iterations", "rms_divergence_1_s", "max_divergence_1_s", "wall_s",
             "dt_bound"},
            {}};
  openings_ = {"openings", {"t_s"}, {}};
  const std::vector<ib3d::Opening>& discs = model.root().fluid().openings();
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
  if (comm_.is_rank_0())
    for (File* file : {&steps_, &openings_, &probes_, &beats_})
      file->writer.emplace(path_of(*file), file->columns);
  write_row({}, 0.0);
  books_.begin(balance_state(model_.model()));
}

void Traces::save_or_restore(Checkpoint& c)
{
  books_.save_or_restore(c);
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

std::vector<double> Traces::probe_row()
{
  const ib3d::ImmersedBoundarySolver& root = model_.root();
  const ib3d::Hierarchy& grid = root.fluid().grid();
  std::vector<double> row{model_.model().t()};
  for (double p : ib3d::pressure_at(grid, root.fluid().p(), centre_[0], centre_[1], probes_z_))
    row.push_back(common::mmHg_from_dyn_cm2(p));
  if (valve_radius_ > 0) {
    q_upstream_ =
        ib3d::flow_through_disc(grid, root.fluid().u(), centre_[0], centre_[1], upstream_z_, valve_radius_);
    q_downstream_ = ib3d::flow_through_disc(grid, root.fluid().u(), centre_[0], centre_[1], downstream_z_,
                                            downstream_radius_);
  }
  orifice_ = edge_nodes_.empty() ? -1 : ib3d::orifice_area(root.nodes().gather(root.X(), edge_nodes_));
  const ib3d::Deformation deformed = root.nodes().part().deformation(root.X());
  const double strain = comm_.max(deformed.largest_strain);
  const double displacement = comm_.max(deformed.largest_displacement);
  row.insert(row.end(), {q_upstream_, q_downstream_, orifice_, strain, displacement});
  return row;
}

void Traces::write_row(const coupling::StepReport& step, double wall_s)
{
  const coupling::InterfaceState& now = model_.model().interface();
  const std::vector<ib3d::Opening>& discs = model_.root().fluid().openings();
  const std::vector<double> probes = probe_row();
  BeatSample sample;
  sample.t_s = now.t_s;
  sample.orifice_cm2 = orifice_;
  for (std::size_t m = 0; m < discs.size(); ++m) {
    sample.inflow_ml_s -= now.flow_ml_s[m];
    if (!forward_at(discs[m])) {
      sample.p_ventricle_mmHg = now.pressure_mmHg[m];
      continue;
    }
    sample.p_aorta_mmHg = now.pressure_mmHg[m];
    sample.flow_ml_s = now.flow_ml_s[m];
  }
  books_.add(sample);
  if (!comm_.is_rank_0()) return;

  std::vector<double> row{now.t_s};
  row.insert(row.end(), now.pressure_mmHg.begin(), now.pressure_mmHg.end());
  for (std::size_t m = 0; m < discs.size(); ++m) row.push_back(along_z(discs[m], now.flow_ml_s[m]));
  const std::vector<double>& y = model_.circulation().state().y;
  row.insert(row.end(), y.begin(), y.end());
  openings_.writer->add(row);
  probes_.writer->add(probes);
  steps_.writer->add({static_cast<double>(step.step), now.t_s, step.dt_s, step.cfl,
                      static_cast<double>(step.iterations), step.divergence_rms, step.divergence_max, wall_s},
                     ib3d::limit_name(step.limited_by));
}

std::optional<BeatMetrics> Traces::record(const coupling::StepReport& step, double wall_s)
{
  const bool ends_beat = model_.model().t() > beat_end() - 1e-9;
  if (step.step % every_ == 0 || ends_beat) write_row(step, wall_s);
  if (!ends_beat) return std::nullopt;
  return close_beat();
}

BeatMetrics Traces::close_beat()
{
  const BeatMetrics metrics = books_.close(balance_state(model_.model()));
  if (beats_.writer) beats_.writer->add(beat_row(metrics));
  flush();
  return metrics;
}

std::optional<BeatMetrics> Traces::finish()
{
  if (books_.under_way()) return close_beat();
  flush();
  return std::nullopt;
}

void Traces::flush()
{
  for (File* file : {&steps_, &openings_, &probes_, &beats_})
    if (file->writer) file->writer->flush();
}

}  // namespace valsalva::run
