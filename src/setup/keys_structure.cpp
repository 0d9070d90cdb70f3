#include "setup/keys.hpp"

namespace valsalva::setup {

using namespace casefile;

namespace {

Section structure_section()
{
  using ib3d::StructureScheme;
  return bound_section<Case, Structure>(
      "structure", "The elastic structure in the fluid", &Case::structure,
      {{choice("kind", {"none", "aortic_root", "files"},
               "Nothing, the aortic root of [root], [leaflets] and [wall], or fibre files"),
        &Structure::kind, std::vector{StructureKind::none, StructureKind::aortic_root, StructureKind::files}},
       {choice("scheme", {"leapfrog", "midpoint"}, "Time stepping of the fibre positions"),
        &Structure::scheme, std::vector{StructureScheme::leapfrog, StructureScheme::midpoint}},
       {real("fold_relaxation_s", "s",
             "Time constant with which folds at the node spacing are flattened by slip through the fluid; 0: "
             "never")
            .at_least(0),
        &Structure::fold_relaxation_s},
       {text("files_prefix", "Path of the fibre files without their extensions, relative to the case"),
        &Structure::files_prefix}});
}

Section root_section()
{
  using ib3d::RootDimensions;
  return bound_section<Case, RootDimensions>(
      "root",
      "Shape of the aortic root: a tube, three sinuses above the scalloped leaflet attachment, ascending "
      "aorta",
      at(&Case::structure, &Structure::root),
      {{real("annulus_radius_cm", "cm", "Radius R of the tube at the annulus").in(0.1, 10.0),
        &RootDimensions::annulus_radius},
       {real("annulus_z_cm", "cm", "Height of the annulus, the lowest points of the leaflet attachment")
            .in(1.0, 100.0),
        &RootDimensions::annulus_z},
       {real("commissure_height_cm", "cm", "Height H of the commissures above the annulus").in(0.1, 10.0),
        &RootDimensions::commissure_height},
       {real("sinus_end_z_cm", "cm", "Height of the sinotubular junction, where the sinuses end")
            .in(0.1, 100.0),
        &RootDimensions::sinus_end_z},
       {real("sinus_bulge_cm", "cm", "Largest distance of the sinus wall from the tube").in(0.0, 5.0),
        &RootDimensions::sinus_bulge},
       {real("ascending_radius_cm", "cm", "Radius of the ascending aorta").in(0.1, 10.0),
        &RootDimensions::ascending_radius},
       {real("end_flare_spacings", "spacings",
             "Widening of both tube ends in grid spacings, which keeps the rim off the pressure discs")
            .in(0.0, 10.0),
        &RootDimensions::end_flare_spacings},
       {reals("center_cm", "cm", "Vessel axis in x and y").of_count(2), &RootDimensions::centre}});
}

/// One list entry per leaflet.
BoundKey<Structure> per_leaflet(const Key& key, double ib3d::LeafletFactors::*factor)
{
  return {key.of_count(3),
          [=](const Structure& s) {
            std::vector<double> list;
            for (const ib3d::LeafletFactors& leaflet : s.factors) list.push_back(leaflet.*factor);
            return CaseValue(list);
          },
          [=](Structure& s, const CaseValue& value) {
            const auto& list = std::get<std::vector<double>>(value);
            for (std::size_t n = 0; n < list.size(); ++n) s.factors[n].*factor = list[n];
          }};
}

Section leaflets_section()
{
  using ib3d::LeafletFactors, ib3d::LeafletMaterial;
  const auto material = [](auto member) { return at(&Structure::leaflets, member); };
  return bound_section<Case, Structure>(
      "leaflets",
      "Three leaflets: a lattice of rows (commissure to commissure) and columns (attachment to free edge)",
      &Case::structure,
      {{real("circumferential_stiffness_dyn_cm", "dyn/cm", "Stiffness of the rows, which bear tension only")
            .in(1e4, 1e9),
        material(&LeafletMaterial::circumferential_stiffness)},
       {real("radial_stiffness_dyn_cm", "dyn/cm", "Stiffness of the columns").in(1e3, 1e9),
        material(&LeafletMaterial::radial_stiffness)},
       {real("bending_rows_dyn_cm", "dyn cm", "Bending rigidity along the rows").in(0.0, 1e5),
        material(&LeafletMaterial::circumferential_bending)},
       {real("bending_columns_dyn_cm", "dyn cm", "Bending rigidity along the columns").in(0.0, 1e5),
        material(&LeafletMaterial::radial_bending)},
       {real("free_edge_ratio", "", "Rest length of the free edge over its arc on the tube").in(0.7, 1.3),
        material(&LeafletMaterial::free_edge_rest_ratio)},
       {real("belly_ratio", "", "Rest length of the rows in the belly over their arc on the tube")
            .in(0.7, 1.3),
        material(&LeafletMaterial::circumferential_rest_ratio)},
       {real("radial_ratio", "", "Rest length of the columns over their length on the tube").in(0.8, 1.4),
        material(&LeafletMaterial::radial_rest_ratio)},
       {real("start_pressure_mmHg", "mmHg", "Pressure under which form-finding shapes the closed leaflets")
            .in(1.0, 120.0),
        material(&LeafletMaterial::start_pressure_mmHg)},
       {real("edge_tether_dyn_cm3", "dyn/cm^3",
             "Stiffness per node area that holds the attached edge in place")
            .in(0.0, 1e12),
        &Structure::edge_tether_dyn_cm3},
       per_leaflet(
           reals("stiffness_factors", "", "Stiffness of rows and columns of leaflets 1, 2, 3 over the above")
               .in(0.1, 20.0),
           &LeafletFactors::stiffness),
       per_leaflet(reals("bending_factors", "", "Bending rigidities of leaflets 1, 2, 3 over the above")
                       .in(0.1, 200.0),
                   &LeafletFactors::bending),
       per_leaflet(
           reals("height_factors", "", "radial_ratio of leaflets 1, 2, 3 over the above; below 1: retracted")
               .in(0.4, 1.3),
           &LeafletFactors::height),
       per_leaflet(reals("free_edge_factors", "",
                         "free_edge_ratio of leaflets 1, 2, 3 over the above; below 1: retracted")
                       .in(0.7, 1.2),
                   &LeafletFactors::free_edge),
       per_leaflet(
           reals(
               "fused_shares", "",
               "Fraction of half the free edge that is fused, starting at the commissure, between leaflets 1 "
               "and 2, 2 and 3, 3 and 1")
               .in(0.0, 1.0),
           &LeafletFactors::fused_share)});
}

Section wall_section()
{
  using ib3d::WallMaterial;
  return bound_section<Case, WallMaterial>(
      "wall", "The wall of the root: layers of nodes held in place by tethers",
      at(&Case::structure, &Structure::wall),
      {{integer("layers", "Layers, half a grid spacing apart; one layer leaks").in(1, 9),
        &WallMaterial::layers},
       {real("spacing_h", "h", "Spacing of the nodes in grid spacings").in(0.2, 1.0),
        &WallMaterial::node_spacing_ratio},
       {real("tether_dyn_cm3", "dyn/cm^3", "Stiffness of the tethers per node area").in(1e4, 1e10),
        &WallMaterial::tether_stiffness}});
}

}  // namespace

std::vector<Section> structure_sections()
{
  return {structure_section(), root_section(), leaflets_section(), wall_section()};
}

}  // namespace valsalva::setup
