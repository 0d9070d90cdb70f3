#include "run/describe.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace valsalva::run {

namespace {

std::string describe_grid(const ib3d::Hierarchy& grid)
{
  std::string text;
  for (const ib3d::Level& level : grid.levels())
    text += fmt::format(
        "grid       {} cells of {:.5g} cm in {} box{}{}\n", level.cell_count(), level.h, level.patches.size(),
        level.patches.size() == 1 ? "" : "es",
        level.cell_count() == level.box.volume()
            ? fmt::format(", {} x {} x {}", level.box.size(0), level.box.size(1), level.box.size(2))
            : std::string());
  return text;
}

/// One line, or one per leaflet where they differ.
std::string describe_leaflets(const std::array<ib3d::LeafletShape, 3>& closed)
{
  std::array<std::string, 3> lines;
  for (std::size_t leaflet = 0; leaflet < 3; ++leaflet) {
    const ib3d::LeafletShape& s = closed[leaflet];
    lines[leaflet] = fmt::format(
        "closed under {:.0f} mmHg: strain {:.3f} mean, {:.3f} largest; tension {:.2g} mean, {:.2g} largest "
        "dyn/cm; coaptation {:.2f} cm\n",
        s.pressure_mmHg, s.circumferential_strain_mean, s.circumferential_strain_max, s.tension_mean,
        s.tension_max, s.coaptation_height_cm);
  }
  if (lines[0] == lines[1] && lines[1] == lines[2]) return "leaflets   " + lines[0];
  std::string text;
  for (std::size_t leaflet = 0; leaflet < 3; ++leaflet)
    text += fmt::format("leaflet {}  {}", leaflet + 1, lines[leaflet]);
  return text;
}

std::string describe_step(const coupling::StepControl& control, double omega)
{
  if (!(omega > 0)) return "";
  const double share = control.dt_fixed_s > 0 ? 0.5 * omega * control.dt_fixed_s : control.elastic_safety;
  return fmt::format("step       elastic bound {:.2e} s at the start (2/omega_max; {:.0f} % of it is used)\n",
                     2 / omega, 100 * share);
}

std::string describe_markers(const std::vector<ib3d::MarkerSeed>& seeds)
{
  std::size_t markers = 0;
  for (const ib3d::MarkerSeed& seed : seeds) markers += seed.points.size();
  if (markers == 0) return "";
  return fmt::format("markers    {} per release, in {} groups\n", markers, seeds.size());
}

/// The domain's inertance at each Windkessel, and how far explicit coupling would be from its limit dt* there
/// (docs/scheme.md, section 4).
std::string describe_coupling(const setup::Case& c, setup::CaseModel& m)
{
  std::string text;
  for (std::size_t port = 0; port < c.network.ports.size(); ++port) {
    const double L = m.model().inertance(static_cast<int>(port));
    for (const lumped::ElementSpec& e : c.network.elements) {
      if (!e.type.starts_with("windkessel") || e.nodes.at("node") != c.network.ports[port]) continue;
      const double C = e.numbers.at("C_ml_mmHg"), R = e.numbers.at("Rc_mmHg_s_ml");
      const double limit = C * (-R + std::sqrt(R * R + 4 * L / C));
      text += fmt::format(
          "coupling   {}: inertance {:.4g} mmHg s^2/ml; explicit coupling would need dt < dt* = {:.3g} s "
          "(longest dt/dt* = {:.2g})\n",
          e.name, L, limit, c.time.steps.dt_max_s / limit);
    }
  }
  return text;
}

}  // namespace

std::string describe_model(const setup::Case& c, setup::CaseModel& m)
{
  const ib3d::FibreNetwork& n = m.structure().network;
  std::string text = describe_grid(m.grid());
  text += fmt::format("structure  {} nodes, {} springs, {} beams, {} tethers\n", n.node_count(),
                      n.springs.count(), n.beams.count(), n.tethers.count());
  if (c.structure.kind == setup::StructureKind::aortic_root) text += describe_leaflets(m.structure().closed);
  text += describe_step(c.time.steps, m.solver().elastic_rate());
  if (!m.start().text.empty()) text += m.start().text + '\n';
  return text + describe_markers(m.solver().markers().seeds()) + describe_coupling(c, m);
}

}  // namespace valsalva::run
