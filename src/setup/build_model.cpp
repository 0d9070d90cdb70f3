#include "setup/build_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "common/error.hpp"
#include "ib3d/structure/fibres/fibre_files.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "setup/marker_seeds.hpp"

namespace valsalva::setup {

namespace {

double h_from_case(const CaseFile& c)
{
  return c.section("grid").real("finest_cm");
}

ib3d::FluidParameters fluid_from_case(const CaseFile& c)
{
  const CaseTable& t = c.section("fluid");
  const std::string& flux = t.text("advection");
  return {t.real("density_g_cm3"), t.real("viscosity_g_cm_s"),
          flux == "none"      ? ib3d::Advection::none
          : flux == "limited" ? ib3d::Advection::limited
                              : ib3d::Advection::xsppm7,
          t.real("convection_cfl"),
          t.text("viscosity_scheme") == "explicit" ? ib3d::ViscosityScheme::explicit_
                                                   : ib3d::ViscosityScheme::crank_nicolson};
}

ib3d::PressureOptions pressure_from_case(const CaseFile& c)
{
  const CaseTable& t = c.section("pressure");
  return {t.text("solver"), t.real("divergence_tolerance_1_s"), t.integer("max_iterations")};
}

ib3d::WallMaterial wall_material(const CaseFile& c)
{
  const CaseTable& t = c.section("wall");
  return {t.real("tether_dyn_cm3"), t.integer("layers"), t.real("spacing_h")};
}

ib3d::LeafletMaterial leaflet_material(const CaseFile& c)
{
  const CaseTable& t = c.section("leaflets");
  ib3d::LeafletMaterial m;
  m.circumferential_stiffness = t.real("circumferential_stiffness_dyn_cm");
  m.radial_stiffness = t.real("radial_stiffness_dyn_cm");
  m.circumferential_bending = t.real("bending_rows_dyn_cm");
  m.radial_bending = t.real("bending_columns_dyn_cm");
  m.circumferential_rest_ratio = t.real("belly_ratio");
  m.free_edge_rest_ratio = t.real("free_edge_ratio");
  m.radial_rest_ratio = t.real("radial_ratio");
  m.edge_tether_ratio = t.real("edge_tether_dyn_cm3") / c.section("wall").real("tether_dyn_cm3");
  m.start_pressure_mmHg = t.real("start_pressure_mmHg");
  return m;
}

std::array<ib3d::LeafletFactors, 3> leaflet_factors(const CaseFile& c)
{
  const CaseTable& t = c.section("leaflets");
  std::array<ib3d::LeafletFactors, 3> factors;
  for (std::size_t n = 0; n < 3; ++n)
    factors[n] = {t.reals("stiffness_factors")[n], t.reals("bending_factors")[n],
                  t.reals("height_factors")[n], t.reals("free_edge_factors")[n], t.reals("fused_shares")[n]};
  return factors;
}

/// Every node must lie in the box; the tube may touch its sides.
void check_inside(const CaseFile& c, const ib3d::FibreNetwork& network, const ib3d::Domain& domain, double h)
{
  for (const Vec3& x : network.X)
    for (int d = 0; d < 3; ++d)
      if (x[d] < -1e-9 * h || x[d] > domain.size[d] + 1e-9 * h)
        throw CaseError({c.section("domain").problem(
            "size_cm",
            fmt::format(
                "holds the fluid in 0 to {:.4g} cm along {}, but the structure reaches {:.4g} cm; make "
                "the box larger or move the structure ({})",
                domain.size[d], "xyz"[d], x[d],
                c.section("structure").text("kind") == "files" ? "in its .vertex file"
                                                               : "[root], center_cm and lengths"))});
}

}  // namespace

bool is_lumped(const CaseFile& c)
{
  return c.tables("opening").empty();
}

ib3d::Domain domain_from_case(const CaseFile& c)
{
  const CaseTable& t = c.section("domain");
  ib3d::Domain domain;
  for (int d = 0; d < 3; ++d) domain.size[d] = t.reals("size_cm")[static_cast<std::size_t>(d)];
  const std::string& sides = t.text("sides");
  domain.sides.fill(ib3d::SideKind::wall);
  for (std::size_t s = 0; s < 4; ++s)
    domain.sides[s] = sides == "open"       ? ib3d::SideKind::open
                      : sides == "periodic" ? ib3d::SideKind::periodic
                                            : ib3d::SideKind::wall;
  return domain;
}

ib3d::RefinementPolicy refinement_from_case(const CaseFile& c)
{
  const CaseTable& t = c.section("grid");
  ib3d::RefinementPolicy policy{
      t.integer("levels"), t.integer("margin_cells"), t.flag("lumen"), t.real("vorticity_1_s"), {}};
  const auto corner = [](const std::vector<double>& x) { return Vec3{x[0], x[1], x[2]}; };
  if (policy.vorticity > 0 && policy.levels == 1)
    throw CaseError({t.problem("vorticity_1_s", "refines, but grid.levels is 1; use more levels")});
  for (const CaseTable& r : c.tables("refine")) {
    if (r.integer("level") >= policy.levels)
      throw CaseError(
          {r.problem("level", fmt::format("is {}, but grid.levels = {} ends with level {}",
                                          r.integer("level"), policy.levels, policy.levels - 1))});
    for (std::size_t d = 0; d < 3; ++d)
      if (r.reals("lo_cm")[d] >= r.reals("hi_cm")[d])
        throw CaseError({r.problem("lo_cm", "must lie below hi_cm in every direction")});
    policy.regions.push_back({corner(r.reals("lo_cm")), corner(r.reals("hi_cm")), r.integer("level")});
  }
  // Discs lie inside the finest level with two coarse cells to spare (else their shape would change at a regrid).
  const double margin = 4 * h_from_case(c);
  for (const ib3d::Opening& o : openings_from_case(c, domain_from_case(c))) {
    const double z = o.side == ib3d::Side::z_lo ? 0 : c.section("domain").reals("size_cm")[2] - margin;
    const Vec3 reach{o.radius + margin, o.radius + margin, 0};
    ib3d::RefinedRegion disc{o.centre - reach, o.centre + reach, policy.levels - 1};
    disc.lo[2] = z;
    disc.hi[2] = z + margin;
    if (policy.levels > 1) policy.regions.push_back(disc);
  }
  return policy;
}

std::vector<ib3d::Opening> openings_from_case(const CaseFile& c, const ib3d::Domain& domain)
{
  std::vector<ib3d::Opening> openings;
  std::vector<CaseProblem> problems;
  for (const CaseTable& t : c.tables("opening")) {
    const std::vector<double>& centre = t.reals("center_cm");
    const double r = t.real("radius_cm");
    openings.push_back({t.text("name"),
                        t.text("side") == "z_lo" ? ib3d::Side::z_lo : ib3d::Side::z_hi,
                        {centre[0], centre[1], 0},
                        r,
                        t.text("port")});
    for (std::size_t d = 0; d < 2; ++d)
      if (centre[d] - r < 0 || centre[d] + r > domain.size[static_cast<int>(d)])
        problems.push_back(t.problem(
            "radius_cm",
            fmt::format(
                "puts the disc outside the box: it reaches from {:.4g} to {:.4g} cm along {}, the box "
                "from 0 to {:.4g} cm; use a smaller disc or a larger domain.size_cm",
                centre[d] - r, centre[d] + r, "xy"[d], domain.size[static_cast<int>(d)])));
    for (std::size_t m = 0; m + 1 < openings.size(); ++m) {
      const ib3d::Opening &a = openings[m], &b = openings.back();
      if (a.side == b.side && norm(a.centre - b.centre) < a.radius + b.radius)
        problems.push_back(
            t.problem("center_cm", fmt::format("lets the disc overlap that of opening \"{}\"", a.name)));
    }
  }
  if (!problems.empty()) throw CaseError(problems);
  return openings;
}

ib3d::RootDimensions root_dimensions_from_case(const CaseFile& c, const ib3d::Domain& domain)
{
  const CaseTable& t = c.section("root");
  ib3d::RootDimensions d;
  d.annulus_radius = t.real("annulus_radius_cm");
  d.annulus_z = t.real("annulus_z_cm");
  d.commissure_height = t.real("commissure_height_cm");
  d.sinus_end_z = t.real("sinus_end_z_cm");
  d.sinus_bulge = t.real("sinus_bulge_cm");
  d.ascending_radius = t.real("ascending_radius_cm");
  d.end_flare_spacings = t.real("end_flare_spacings");
  d.centre[0] = t.reals("center_cm")[0];
  d.centre[1] = t.reals("center_cm")[1];
  d.length = domain.size[2];
  return d;
}

coupling::StepControl step_control_from_case(const CaseFile& c)
{
  const CaseTable& t = c.section("time");
  return {t.real("cfl"), t.real("elastic_safety"), t.real("dt_max_s"), t.real("dt_fixed_s")};
}

Structure structure_from_case(const CaseFile& c, const ib3d::Domain& domain, double h, double valve_load_mmHg)
{
  const CaseTable& t = c.section("structure");
  Structure structure;
  if (t.text("kind") == "aortic_root") {
    ib3d::LeafletMaterial leaflets = leaflet_material(c);
    leaflets.start_pressure_mmHg = std::max(leaflets.start_pressure_mmHg, valve_load_mmHg);
    ib3d::AorticRoot root = ib3d::design_aortic_root(root_dimensions_from_case(c, domain), leaflets,
                                                     wall_material(c), h, leaflet_factors(c));
    structure = {std::move(root.network), root.closed, root.start, true};
  } else if (t.text("kind") == "files") {
    if (t.text("files_prefix").empty())
      throw CaseError({t.problem("files_prefix",
                                 "is empty; name the fibre files, for instance \"valve\" for valve.vertex")});
    structure.network =
        ib3d::read_fibre_files((std::filesystem::path(c.folder()) / t.text("files_prefix")).string());
  }
  check_inside(c, structure.network, domain, h);
  return structure;
}

namespace {

lumped::NetworkSpec network_with_balance(const CaseFile& c)
{
  lumped::NetworkSpec spec = network_from_case(c);
  spec.balance = true;
  return spec;
}

}  // namespace

CaseModel::CaseModel(const CaseFile& c, MPI_Comm comm, Timers& timers)
    : start_(network_start(c, network_with_balance(c))),
      circulation_(start_.spec, start_.state),
      domain_(domain_from_case(c)),
      refinement_(refinement_from_case(c)),
      structure_(structure_from_case(c, domain_,
                                     ib3d::finest_spacing(domain_, h_from_case(c), refinement_.levels),
                                     start_.valve_load_mmHg)),
      root_(ib3d::Hierarchy(domain_, h_from_case(c), comm,
                            ib3d::refine(domain_, h_from_case(c), refinement_, structure_.network.X),
                            structure_.network.X),
            openings_from_case(c, domain_), fluid_from_case(c), pressure_from_case(c),
            std::make_unique<ib3d::FibreModel>(structure_.network,
                                               c.section("structure").real("fold_relaxation_s")),
            c.section("structure").text("scheme") == "midpoint" ? ib3d::StructureScheme::midpoint
                                                                : ib3d::StructureScheme::leapfrog,
            timers, refinement_,
            marker_seeds_from_case(c, domain_,
                                   ib3d::finest_spacing(domain_, h_from_case(c), refinement_.levels))),
      model_(root_, circulation_,
             c.section("coupling").text("scheme") == "explicit" ? coupling::CouplingScheme::explicit_
                                                                : coupling::CouplingScheme::implicit_,
             step_control_from_case(c), timers)
{
}

}  // namespace valsalva::setup
