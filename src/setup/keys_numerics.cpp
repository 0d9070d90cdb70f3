#include "setup/keys.hpp"

namespace valsalva::setup {

using namespace casefile;
using coupling::CouplingScheme;
using coupling::StepControl;
using ib3d::RefinementPolicy;

namespace {

Section time_section()
{
  return bound_section<Case, Time>(
      "time", "Length of the run and of its steps", &Case::time,
      {BoundKey<Time>(real("end_s", "s", "End of the run").above(0), &Time::end_s).needed(),
       {real("period_s", "s", "Length of a beat; 0: the whole run is one beat").at_least(0), &Time::period_s},
       {real(
            "stop_when_periodic_within", "",
            "Stop after the first beat whose stroke volume and mean, systolic and diastolic aortic pressures "
            "differ from the previous beat by less than this fraction; 0: run to end_s")
            .in(0.0, 0.5),
        &Time::stop_when_periodic_within},
       {choice("start", {"rest", "periodic"},
               "Start the network from its initial values, or from the periodic state of the case in 0D"),
        &Time::start, std::vector{Start::rest, Start::periodic}},
       {real("cfl", "", "Largest dt (|u| + |v| + |w|)/h of an automatic step").in(0.05, 0.5),
        at(&Time::steps, &StepControl::cfl)},
       {real("dt_max_s", "s", "Longest automatic step").in(1e-9, 1.0),
        at(&Time::steps, &StepControl::dt_max_s)},
       {real("dt_fixed_s", "s", "Fixed step; 0: automatic steps").in(0.0, 1.0),
        at(&Time::steps, &StepControl::dt_fixed_s)},
       {real("elastic_safety", "", "Automatic step as a fraction of the structure's stable step")
            .in(0.01, 1.0),
        at(&Time::steps, &StepControl::elastic_safety)}});
}

/// The four planes along z have one kind; those across z are walls with openings.
Section domain_section()
{
  using ib3d::Domain, ib3d::SideKind;
  const std::vector<std::string> words{"wall", "open", "periodic"};
  const std::vector<SideKind> kinds{SideKind::wall, SideKind::open, SideKind::periodic};
  return bound_section<Case, Domain>(
      "domain", "The box of fluid, z along the vessel", &Case::domain,
      {{reals("size_cm", "cm", "Lengths of the box along x, y, z").above(0).of_count(3), &Domain::size},
       {choice("sides", words, "The four planes along z: no slip, fluid at zero pressure, or periodic"),
        [=](const Domain& d) {
          return CaseValue(words[static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), d.sides[0]) -
                                                          kinds.begin())]);
        },
        [=](Domain& d, const CaseValue& word) {
          const auto found = std::find(words.begin(), words.end(), std::get<std::string>(word));
          std::fill_n(d.sides.begin(), 4, kinds[static_cast<std::size_t>(found - words.begin())]);
        }}});
}

Section grid_section()
{
  const auto policy = [](auto member) { return at(&Grid::refinement, member); };
  return bound_section<Case, Grid>(
      "grid", "The computational grid", &Case::grid,
      {{real("finest_cm", "cm", "Spacing h of the finest cells; divides the box").in(1e-3, 10.0),
        &Grid::finest_cm},
       {integer("levels", "Levels of refinement by 2; the finest holds the structure").in(1, 8),
        policy(&RefinementPolicy::levels)},
       {integer("margin_cells", "Finest cells that structure and vorticity may move before the grid follows")
            .in(1, 64),
        policy(&RefinementPolicy::margin_cells)},
       {real("vorticity_1_s", "1/s",
             "Refine where the vorticity exceeds this value; 0: do not refine by vorticity")
            .at_least(0),
        policy(&RefinementPolicy::vorticity)},
       {flag("lumen", "Refine what the structure encloses in planes across z, not only what is near it"),
        policy(&RefinementPolicy::lumen)}});
}

Section fluid_section()
{
  using ib3d::Advection, ib3d::FluidParameters, ib3d::ViscosityScheme;
  return bound_section<Case, FluidParameters>(
      "fluid", "Blood as a Newtonian fluid", &Case::fluid,
      {{real("density_g_cm3", "g/cm^3", "Density").in(0.1, 10.0), &FluidParameters::density},
       {real("viscosity_g_cm_s", "g/(cm s)", "Dynamic viscosity").in(0.0, 100.0),
        &FluidParameters::viscosity},
       {choice("advection", {"xsppm7", "limited", "none"},
               "Convective flux: from seven values, from three with a limiter, or none (Stokes flow)"),
        &FluidParameters::advection, std::vector{Advection::xsppm7, Advection::limited, Advection::none}},
       {real("convection_cfl", "",
             "Recompute convection when the accumulated CFL number would exceed this value, and at least "
             "every "
             "eighth step; extrapolate in between. 0: recompute in every step")
            .in(0.0, 0.5),
        &FluidParameters::convection_cfl},
       {choice("viscosity_scheme", {"explicit", "crank_nicolson"},
               "Viscous term from the start of the step, or the mean of both ends, which bounds no step"),
        &FluidParameters::viscosity_scheme,
        std::vector{ViscosityScheme::explicit_, ViscosityScheme::crank_nicolson}}});
}

Section pressure_section()
{
  using ib3d::PressureOptions;
  return bound_section<Case, PressureOptions>(
      "pressure", "The pressure equation of every step", &Case::pressure,
      {{choice("solver", {"multilevel", "pfmg"}, "Own multigrid, or the one of hypre (one level only)"),
        &PressureOptions::solver},
       {real("divergence_tolerance_1_s", "1/s", "Rms of div u at which the iteration stops").above(0),
        &PressureOptions::divergence_tolerance},
       {integer("max_iterations", "Iterations after which the solve counts as failed").in(1, 10000),
        &PressureOptions::max_iterations}});
}

}  // namespace

std::vector<Section> numerics_sections()
{
  return {time_section(),
          domain_section(),
          grid_section(),
          fluid_section(),
          pressure_section(),
          bound_section<Case, Case>(
              "coupling", "How the 3D openings and the lumped network meet", std::identity{},
              {{choice("scheme", {"implicit", "explicit"},
                       "Pressures from the flow at the end or at the start of the step"),
                &Case::coupling, std::vector{CouplingScheme::implicit_, CouplingScheme::explicit_}}})};
}

}  // namespace valsalva::setup
