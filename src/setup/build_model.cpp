#include "setup/build_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"
#include "ib3d/structure/fibres/fibre_files.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "setup/marker_seeds.hpp"

namespace valsalva::setup {

namespace {

/// Every node must lie in the box; the tube may touch its sides.
void check_inside(const Case& c, const ib3d::FibreNetwork& network)
{
  const double slack = 1e-9 * c.finest_spacing();
  for (const Vec3& x : network.X)
    for (int d = 0; d < 3; ++d)
      if (x[d] < -slack || x[d] > c.domain.size[d] + slack)
        throw CaseError(
            "domain.size_cm",
            fmt::format("holds the fluid in 0 to {:.4g} cm along {}, but the structure reaches {:.4g} cm; "
                        "make the box larger or move the structure ({})",
                        c.domain.size[d], "xyz"[d], x[d],
                        c.structure.kind == StructureKind::files ? "in its .vertex file"
                                                                 : "[root], center_cm and lengths"));
}

/// The regions of the case, and one about every opening: discs lie inside the finest level with two coarse cells to
/// spare, or their shape would change at a regrid.
ib3d::RefinementPolicy refinement_of(const Case& c)
{
  ib3d::RefinementPolicy policy = c.grid.refinement;
  for (const Refine& r : c.refine) policy.regions.push_back(r.region);
  const double margin = 4 * c.grid.finest_cm;
  if (policy.levels > 1)
    for (const ib3d::Opening& o : c.openings) {
      const double reach = o.radius + margin;
      const int across = ib3d::axis(o.side);
      ib3d::RefinedRegion disc{o.centre - Vec3{reach, reach, reach}, o.centre + Vec3{reach, reach, reach},
                               policy.levels - 1};
      disc.lo[across] = ib3d::is_high(o.side) ? c.domain.size[across] - margin : 0;
      disc.hi[across] = disc.lo[across] + margin;
      policy.regions.push_back(disc);
    }
  return policy;
}

lumped::NetworkSpec network_with_balance(const Case& c)
{
  lumped::NetworkSpec spec = c.network;
  spec.balance = true;
  return spec;
}

}  // namespace

BuiltStructure build_structure(const Case& c, double valve_load_mmHg)
{
  BuiltStructure built;
  if (c.structure.kind == StructureKind::aortic_root) {
    ib3d::LeafletMaterial leaflets = c.structure.leaflets;
    leaflets.edge_tether_ratio = c.structure.edge_tether_dyn_cm3 / c.structure.wall.tether_stiffness;
    leaflets.start_pressure_mmHg = max_or_nan(leaflets.start_pressure_mmHg, valve_load_mmHg);
    ib3d::AorticRoot root = ib3d::design_aortic_root(c.structure.root, leaflets, c.structure.wall,
                                                     c.finest_spacing(), c.structure.factors);
    built = {std::move(root.network), root.closed, root.start};
  } else if (c.structure.kind == StructureKind::files) {
    built.network = ib3d::read_fibre_files(c.path_of(c.structure.files_prefix));
  }
  check_inside(c, built.network);
  return built;
}

CaseModel::CaseModel(const Case& c, const Communicator& comm, Timers& timers)
    : start_(network_start(c, network_with_balance(c), comm)),
      circulation_(start_.spec, start_.state, comm),
      refinement_(refinement_of(c)),
      structure_(build_structure(c, start_.valve_load_mmHg)),
      solver_(ib3d::Hierarchy(c.domain, c.grid.finest_cm, comm.raw(),
                              ib3d::refine(c.domain, c.grid.finest_cm, refinement_, structure_.network.X),
                              structure_.network.X),
              c.openings, c.fluid, c.pressure,
              std::make_unique<ib3d::FibreModel>(structure_.network, c.structure.fold_relaxation_s),
              c.structure.scheme, timers, refinement_, marker_seeds(c)),
      model_(solver_, circulation_, c.coupling, c.time.steps, timers)
{
}

}  // namespace valsalva::setup
