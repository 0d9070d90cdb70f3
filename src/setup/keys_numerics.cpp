#include "setup/keys_parts.hpp"

namespace valsalva::setup {

using namespace casefile;

std::vector<KeySection> numerics_sections()
{
  return {
      {"time",
       "Length of the run and of its steps",
       {real("end_s", "s", "End of the run").above(0),
        real("period_s", "s", "Length of a beat; 0: the whole run is one beat").at_least(0).or_else(0.0),
        real("stop_when_periodic_within", "",
             "End after a beat whose stroke volume and mean, systolic and diastolic aortic pressures differ "
             "from the "
             "beat before by less than this share; 0: go on to end_s")
            .in(0.0, 0.5)
            .or_else(0.0),
        choice("start", {"rest", "periodic"},
               "The network starts from its initial values, or from the periodic state of the case in 0D")
            .or_else("rest"),
        real("cfl", "", "Largest dt (|u| + |v| + |w|)/h of an automatic step").in(0.05, 0.5).or_else(0.4),
        real("dt_max_s", "s", "Longest automatic step").in(1e-9, 1.0).or_else(2e-4),
        real("dt_fixed_s", "s", "Fixed step; 0: automatic steps").in(0.0, 1.0).or_else(0.0),
        real("elastic_safety", "", "Automatic step as a fraction of the structure's stable step")
            .in(0.01, 1.0)
            .or_else(0.95)}},
      {"domain",
       "The box of fluid, z along the vessel",
       {reals("size_cm", "cm", "Lengths of the box along x, y, z")
            .above(0)
            .of_count(3)
            .or_else({5.0, 5.0, 15.0}),
        choice("sides", {"wall", "open", "periodic"},
               "The four planes along z: no slip, fluid at zero pressure, or periodic")
            .or_else("wall")}},
      {"grid",
       "The computational grid",
       {real("finest_cm", "cm", "Spacing h of the finest cells; divides the box")
            .in(1e-3, 10.0)
            .or_else(0.104167),
        integer("levels", "Levels of refinement by 2; the finest holds the structure").in(1, 8).or_else(1),
        integer("margin_cells", "Finest cells that structure and vorticity may move before the grid follows")
            .in(1, 64)
            .or_else(2),
        real("vorticity_1_s", "1/s", "Refine where the vorticity is larger; 0: not for its sake")
            .at_least(0)
            .or_else(0.0),
        flag("lumen", "Refine what the structure encloses in planes across z, not only what is near it")
            .or_else(true)}},
      {"fluid",
       "Blood as a Newtonian fluid",
       {real("density_g_cm3", "g/cm^3", "Density").in(0.1, 10.0).or_else(1.0),
        real("viscosity_g_cm_s", "g/(cm s)", "Dynamic viscosity").in(0.0, 100.0).or_else(0.04),
        choice("advection", {"xsppm7", "limited", "none"},
               "Convective flux: from seven values, from three with a limiter, or none (Stokes flow)")
            .or_else("xsppm7"),
        real("convection_cfl", "",
             "Convection is found anew before the CFL numbers of the steps since the last time sum up to "
             "more, at "
             "the latest in every eighth step; between, it is extrapolated in time. 0: in every step")
            .in(0.0, 0.5)
            .or_else(0.4),
        choice("viscosity_scheme", {"explicit", "crank_nicolson"},
               "Viscous term from the start of the step, or the mean of both ends, which bounds no step")
            .or_else("explicit")}},
      {"pressure",
       "The pressure equation of every step",
       {choice("solver", {"multilevel", "pfmg"}, "Own multigrid, or the one of hypre").or_else("multilevel"),
        real("divergence_tolerance_1_s", "1/s", "Rms of div u at which the iteration stops")
            .above(0)
            .or_else(5e-3),
        integer("max_iterations", "Iterations after which the solve counts as failed")
            .in(1, 10000)
            .or_else(60)}},
      {"coupling",
       "How the 3D openings and the lumped network meet",
       {choice("scheme", {"implicit", "explicit"},
               "Pressures from the flow at the end or at the start of the step")
            .or_else("implicit")}},
  };
}

KeySection output_section()
{
  return {
      "output",
      "What is written, and how often",
      {real("fields_every_s", "s", "Interval of velocity and pressure fields; 0: none")
           .at_least(0)
           .or_else(0.02),
       real("structure_every_s", "s", "Interval of the structure's shape; 0: none").at_least(0).or_else(0.01),
       integer("traces_every_steps", "Steps between two rows of the CSV traces").in(1, 1e6).or_else(1),
       reals("probes_z_cm", "cm", "Heights on the centre line at which pressure is traced")
           .at_least(0)
           .or_else({0.5, 3.5, 4.5, 5.5, 8.0, 14.5}),
       flag("pictures", "Draw pictures when the run has ended").or_else(true),
       flag("report", "Write report.html with the pictures").or_else(true),
       real("progress_every_s", "s", "Seconds of the wall clock between two lines of progress")
           .at_least(0)
           .or_else(5.0)}};
}

KeyArray refine_array()
{
  return {"refine",
          "A part of the box that is refined by hand",
          {text("name", "Unique name of the part"), reals("lo_cm", "cm", "Lower corner").of_count(3),
           reals("hi_cm", "cm", "Upper corner").of_count(3),
           integer("level", "Level that covers it; 0 is the coarsest").in(1, 8)},
          {}};
}

KeyArray markers_array()
{
  return {"markers",
          "Passive markers that the flow carries, written with the structure",
          {text("name", "Unique name of the group"),
           reals("z_cm", "cm", "Heights of the planes across z in which they set out").at_least(0),
           real("spacing_cm", "cm", "Distance of the markers within a plane").in(0.005, 10.0).or_else(0.1),
           real("radius_cm", "cm",
                "Radius of the planes' discs; 0: the lumen of the aortic root, else the narrowest opening's")
               .in(0.0, 100.0)
               .or_else(0.0),
           reals("center_cm", "cm", "Centre of the discs in x and y; absent: root.center_cm")
               .of_count(2)
               .optional(),
           real("start_s", "s", "When they set out").at_least(0).or_else(0.0),
           real("every_s", "s", "Others set out at this interval; 0: once").at_least(0).or_else(0.0),
           real("end_s", "s", "None set out later; absent: until the end of the run").at_least(0).optional()},
          {}};
}

KeySection checkpoint_section()
{
  return {
      "checkpoint",
      "From what a run can be continued (`valsalva run --restart latest`); one is always written at the end",
      {real("every_wall_s", "s", "Seconds of the wall clock between two checkpoints; 0: only at the end")
           .at_least(0)
           .or_else(300.0),
       integer("keep", "Checkpoints that are kept, the newest ones").in(1, 1000).or_else(2)}};
}

KeyArray opening_array()
{
  return {"opening",
          "A disc on a z plane of the box whose pressure a node of the lumped network prescribes",
          {text("name", "Unique name of the opening"),
           choice("side", {"z_lo", "z_hi"}, "Plane of the disc: lower or upper end of the box"),
           reals("center_cm", "cm", "Centre of the disc in x and y").of_count(2),
           real("radius_cm", "cm", "Radius of the disc").above(0),
           text("port", "Node of the network that is joined to the opening")},
          {}};
}

}  // namespace valsalva::setup
