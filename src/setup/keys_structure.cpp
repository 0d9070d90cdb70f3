#include "setup/keys_parts.hpp"

namespace valsalva::setup {

using namespace casefile;

namespace {

KeySection root_section()
{
  return {"root",
          "Shape of the aortic root: a tube, three sinuses above the scalloped leaflet attachment, ascending "
          "aorta",
          {real("annulus_radius_cm", "cm", "Radius R of the tube at the annulus").in(0.1, 10.0).or_else(1.15),
           real("annulus_z_cm", "cm", "Height of the annulus, the lowest points of the leaflet attachment")
               .in(0.0, 100.0)
               .or_else(3.2),
           real("commissure_height_cm", "cm", "Height H of the commissures above the annulus")
               .in(0.1, 10.0)
               .or_else(1.58),
           real("sinus_end_z_cm", "cm", "Height of the sinotubular junction, where the sinuses end")
               .in(0.1, 100.0)
               .or_else(5.3),
           real("sinus_bulge_cm", "cm", "Largest distance of the sinus wall from the tube")
               .in(0.0, 5.0)
               .or_else(0.52),
           real("ascending_radius_cm", "cm", "Radius of the ascending aorta").in(0.1, 10.0).or_else(1.30),
           real("end_flare_spacings", "spacings",
                "Widening of both tube ends in grid spacings, which keeps the rim off the pressure discs")
               .in(0.0, 10.0)
               .or_else(1.75),
           reals("center_cm", "cm", "Vessel axis in x and y").of_count(2).or_else({2.5, 2.5})}};
}

KeySection leaflets_section()
{
  return {
      "leaflets",
      "Three leaflets: a lattice of rows (commissure to commissure) and columns (attachment to free edge)",
      {real("circumferential_stiffness_dyn_cm", "dyn/cm", "Stiffness of the rows, which bear tension only")
           .above(0)
           .or_else(1e6),
       real("radial_stiffness_dyn_cm", "dyn/cm", "Stiffness of the columns").at_least(0).or_else(1.5e5),
       real("bending_rows_dyn_cm", "dyn cm", "Bending rigidity along the rows").at_least(0).or_else(100.0),
       real("bending_columns_dyn_cm", "dyn cm", "Bending rigidity along the columns")
           .at_least(0)
           .or_else(200.0),
       real("free_edge_ratio", "", "Rest length of the free edge over its arc on the tube")
           .in(0.5, 2.0)
           .or_else(1.06),
       real("belly_ratio", "", "Rest length of the rows in the belly over their arc on the tube")
           .in(0.5, 2.0)
           .or_else(0.97),
       real("radial_ratio", "", "Rest length of the columns over their length on the tube")
           .in(0.5, 2.0)
           .or_else(1.10),
       real("start_pressure_mmHg", "mmHg", "Pressure under which form-finding shapes the closed leaflets")
           .in(0.1, 200.0)
           .or_else(3.0),
       real("edge_tether_dyn_cm3", "dyn/cm^3",
            "Stiffness per node area that holds the attached edge in place")
           .at_least(0)
           .or_else(8e7),
       reals("stiffness_factors", "", "Stiffness of rows and columns of leaflets 1, 2, 3 over the above")
           .of_count(3)
           .in(0.1, 20.0)
           .or_else({1.0, 1.0, 1.0}),
       reals("bending_factors", "", "Bending rigidities of leaflets 1, 2, 3 over the above")
           .of_count(3)
           .in(0.1, 200.0)
           .or_else({1.0, 1.0, 1.0}),
       reals("height_factors", "", "radial_ratio of leaflets 1, 2, 3 over the above; below 1: retracted")
           .of_count(3)
           .in(0.4, 1.3)
           .or_else({1.0, 1.0, 1.0}),
       reals("free_edge_factors", "",
             "free_edge_ratio of leaflets 1, 2, 3 over the above; below 1: retracted")
           .of_count(3)
           .in(0.7, 1.2)
           .or_else({1.0, 1.0, 1.0}),
       reals("fused_shares", "",
             "Share of half the free edge that is grown together, from the commissure on, between leaflets 1 "
             "and 2, 2 "
             "and 3, 3 and 1")
           .of_count(3)
           .in(0.0, 1.0)
           .or_else({0.0, 0.0, 0.0})}};
}

}  // namespace

std::vector<KeySection> structure_sections()
{
  return {
      {"structure",
       "The elastic structure in the fluid",
       {choice("kind", {"none", "aortic_root", "files"},
               "Nothing, the aortic root of [root], [leaflets] and [wall], or fibre files")
            .or_else("none"),
        choice("scheme", {"leapfrog", "midpoint"}, "Time stepping of the fibre positions")
            .or_else("leapfrog"),
        real("fold_relaxation_s", "s",
             "Time in which folds of the node spacing are flattened through the fluid, which does not feel "
             "them; "
             "0: never")
            .at_least(0)
            .or_else(0.0),
        text("files_prefix", "Path of the fibre files without their endings, relative to the case")
            .or_else("")}},
      root_section(),
      leaflets_section(),
      {"wall",
       "The wall of the root: layers of nodes held in place by tethers",
       {integer("layers", "Layers, half a grid spacing apart; one layer leaks").in(1, 9).or_else(3),
        real("spacing_h", "h", "Spacing of the nodes in grid spacings").in(0.1, 1.0).or_else(0.6),
        real("tether_dyn_cm3", "dyn/cm^3", "Stiffness of the tethers per node area").above(0).or_else(1e7)}}};
}

}  // namespace valsalva::setup
