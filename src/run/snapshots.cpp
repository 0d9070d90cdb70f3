#include "run/snapshots.hpp"

#include <filesystem>
#include <limits>

#include "common/units.hpp"
#include "ib3d/output/vtkhdf.hpp"

namespace valsalva::run {

namespace {

ib3d::AmrBlock block_of(const ib3d::Level& level, const ib3d::MacField& u, const ib3d::CellField<double>& p,
                        int patch)
{
  const ib3d::IndexBox& box = level.local_box(patch);
  ib3d::AmrBlock block;
  block.order = level.local[static_cast<std::size_t>(patch)];
  block.velocity.reserve(static_cast<std::size_t>(3 * box.volume()));
  block.pressure.reserve(static_cast<std::size_t>(box.volume()));
  ib3d::for_each_index(box, [&](int i, int j, int k) {
    block.velocity.push_back(static_cast<float>(0.5 * (u(patch, 0)(i, j, k) + u(patch, 0)(i + 1, j, k))));
    block.velocity.push_back(static_cast<float>(0.5 * (u(patch, 1)(i, j, k) + u(patch, 1)(i, j + 1, k))));
    block.velocity.push_back(static_cast<float>(0.5 * (u(patch, 2)(i, j, k) + u(patch, 2)(i, j, k + 1))));
    block.pressure.push_back(static_cast<float>(common::mmHg_from_dyn_cm2(p[patch](i, j, k))));
  });
  return block;
}

bool is_wall(const ib3d::NodeGroup& group)
{
  return group.name.starts_with("wall");
}

/// The group of every node of the whole structure.
std::vector<int> group_of_nodes(const ib3d::ElasticModel& whole)
{
  std::vector<int> group(static_cast<std::size_t>(whole.node_count()), 0);
  for (std::size_t g = 0; g < whole.groups().size(); ++g)
    for (int n = whole.groups()[g].first; n < whole.groups()[g].last; ++n)
      group[static_cast<std::size_t>(n)] = static_cast<int>(g);
  return group;
}

}  // namespace

Snapshots::Snapshots(const std::string& folder, const setup::Output& output, setup::CaseModel& model,
                     const Communicator& comm)
    : folder_(folder),
      model_(model),
      comm_(comm),
      has_structure_(model.structure().network.node_count() > 0),
      has_markers_(model.solver().markers().wanted())
{
  const double never = std::numeric_limits<double>::infinity();
  fields_.every_s = output.fields_every_s;
  structure_.every_s = output.structure_every_s;
  if (fields_.every_s == 0) fields_.every_s = fields_.next_s = never;
  if (structure_.every_s == 0 || (!has_structure_ && !has_markers_))
    structure_.every_s = structure_.next_s = never;
  common::on_rank_0(comm, [&] {
    for (const char* sub : {"fields", "structure"}) std::filesystem::create_directories(folder + "/" + sub);
    field_series_.emplace(folder + "/fields/fields.hdf.series");
    if (has_structure_) structure_series_.emplace(folder + "/structure/leaflets.hdf.series");
    if (has_markers_) marker_series_.emplace(folder + "/structure/markers.hdf.series");
  });
}

void Snapshots::list(std::optional<ib3d::FileSeries>& series, const std::string& name, double t) const
{
  common::on_rank_0(comm_, [&] { series->add(name, t); });
}

void Snapshots::write_due()
{
  const double t = model_.model().t();
  if (fields_.due(t)) {
    write_fields(t);
    fields_.done(t);
  }
  if (structure_.due(t)) {
    if (has_structure_) {
      if (structure_.count == 0) write_structure("wall.hdf", t, true);
      const std::string name = ib3d::numbered_file("leaflets", structure_.count);
      write_structure(name, t, false);
      list(structure_series_, name, t);
    }
    if (has_markers_) {
      const std::string name = ib3d::numbered_file("markers", structure_.count);
      write_markers(name, t);
      list(marker_series_, name, t);
    }
    structure_.done(t);
  }
}

void Snapshots::save_or_restore(Checkpoint& c)
{
  c("snapshots/fields", fields_.count);
  c("snapshots/structure", structure_.count);
  if (!c.reading()) return;
  for (Schedule* s : {&fields_, &structure_}) s->plan_after(model_.model().t());
  common::on_rank_0(comm_, [&] {
    field_series_->cut_to(fields_.count);
    if (structure_series_) structure_series_->cut_to(structure_.count);
    if (marker_series_) marker_series_->cut_to(structure_.count);
  });
}

void Snapshots::write_fields(double t)
{
  const ib3d::NavierStokes& fluid = model_.solver().fluid();
  std::vector<ib3d::AmrLevel> levels;
  for (std::size_t l = 0; l < fluid.u().size(); ++l) {
    const ib3d::Level& level = fluid.grid().levels()[l];
    ib3d::AmrLevel& out = levels.emplace_back(ib3d::AmrLevel{level.h, {}, {}});
    for (const ib3d::Patch& p : level.patches) out.boxes.push_back(p.box);
    for (int p = 0; p < level.local_count(); ++p)
      out.local.push_back(block_of(level, fluid.u()[l], fluid.p()[l], p));
  }
  const std::string name = ib3d::numbered_file("fields", fields_.count);
  ib3d::write_overlapping_amr(folder_ + "/fields/" + name, t, Vec3{0, 0, 0}, levels, comm_.raw());
  list(field_series_, name, t);
}

void Snapshots::write_structure(const std::string& name, double t, bool wall)
{
  const ib3d::NodeDistribution& nodes = model_.solver().nodes();
  const std::vector<Vec3>& X = model_.solver().X();
  const std::vector<int> group = group_of_nodes(nodes.whole());
  std::vector<std::string> names;
  for (const ib3d::NodeGroup& g : nodes.whole().groups()) names.push_back(g.name);

  ib3d::StructurePicture picture;
  std::vector<int> number(X.size(), -1);  // of a local node among the picture's points
  const auto add_point = [&](int n) {
    const auto i = static_cast<std::size_t>(n);
    if (number[i] < 0) {
      number[i] = static_cast<int>(picture.points.size());
      picture.points.push_back(X[i]);
      picture.group.push_back(group[static_cast<std::size_t>(nodes.global()[i])]);
    }
    return number[i];
  };
  for (int n = 0; n < nodes.owned(); ++n) {
    const auto g = static_cast<std::size_t>(
        group[static_cast<std::size_t>(nodes.global()[static_cast<std::size_t>(n)])]);
    const bool in_wall = !nodes.whole().groups().empty() && is_wall(nodes.whole().groups()[g]);
    if (in_wall == wall) add_point(n);
  }
  const ib3d::StrainedElements drawing = wall ? ib3d::StrainedElements{} : nodes.part().drawing(X);
  for (int e = 0; e < drawing.elements.count(); ++e) {
    const std::span<const int> joined = drawing.elements[e];
    if (joined[0] >= nodes.owned()) continue;  // the owner of its first node draws it
    std::vector<int> points;
    for (const int n : joined) points.push_back(add_point(n));
    picture.elements.add(points);
    picture.strain.push_back(static_cast<float>(drawing.strain[static_cast<std::size_t>(e)]));
  }
  ib3d::write_structure(folder_ + "/structure/" + name, t, picture, names, comm_.raw());
}

void Snapshots::write_markers(const std::string& name, double t)
{
  const ib3d::Markers& markers = model_.solver().markers();
  std::vector<std::string> names;
  for (const ib3d::MarkerSeed& seed : markers.seeds()) names.push_back(seed.name);
  ib3d::MarkerPicture picture;
  for (const ib3d::Marker& m : markers.local()) {
    picture.points.push_back(m.X);
    picture.id.push_back(m.id);
    picture.group.push_back(m.group);
    picture.age.push_back(static_cast<float>(t - m.seeded_s));
  }
  ib3d::write_markers(folder_ + "/structure/" + name, t, picture, names, comm_.raw());
}

}  // namespace valsalva::run
