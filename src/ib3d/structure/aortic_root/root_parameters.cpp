#include "ib3d/structure/aortic_root/root_parameters.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "ib3d/structure/aortic_root/root_shape.hpp"

namespace valsalva::ib3d {

namespace {

class Problems {
 public:
  void require(bool holds, const std::string& key, const std::string& message)
  {
    if (!holds) found_.push_back(CaseProblem{"", 0, 0, key, message});
  }
  void require_between(const std::string& key, double value, double low, double high, const std::string& unit)
  {
    const std::string suffix = unit.empty() ? "" : " " + unit;
    require(value >= low && value <= high, key,
            fmt::format("found {:.6g}{}, but it must lie between {:.6g} and {:.6g}{}.", value, suffix, low,
                        high, suffix));
  }
  std::vector<CaseProblem> take() { return std::move(found_); }

 private:
  std::vector<CaseProblem> found_;
};

void check_dimensions(const RootDimensions& root, double h, Problems& problems)
{
  const double R = root.annulus_radius;
  const double commissure_z = root.annulus_z + root.commissure_height;
  problems.require(R > 0.0, "root.annulus_radius_cm",
                   fmt::format("found {:.6g} cm, but a radius must be positive.", R));
  problems.require(
      h > 0.0 && h <= R / 4.0, "grid.finest_cm",
      fmt::format("found {:.6g} cm, but an annulus of radius {:.6g} cm needs a spacing of at most "
                  "a quarter of it; refine the grid.",
                  h, R));
  problems.require_between("root.annulus_z_cm", root.annulus_z, 1.0, root.length, "cm");
  problems.require_between("root.commissure_height_cm", root.commissure_height, 0.5 * R, 2.5 * R, "cm");
  problems.require(
      root.sinus_end_z >= commissure_z + 0.1, "root.sinus_end_z_cm",
      fmt::format("found {:.6g} cm, but the sinuses must end at least 0.1 cm beyond the commissures "
                  "at annulus_z_cm + commissure_height_cm = {:.6g} cm.",
                  root.sinus_end_z, commissure_z));
  problems.require(
      root.sinus_end_z <= root.length - 1.0, "root.sinus_end_z_cm",
      fmt::format("found {:.6g} cm, but the sinuses must end before the flare of the outlet begins "
                  "at {:.6g} cm.",
                  root.sinus_end_z, root.length - 1.0));
  problems.require_between("root.sinus_bulge_cm", root.sinus_bulge, 0.0, R, "cm");
  problems.require_between("root.ascending_radius_cm", root.ascending_radius, 0.5 * R, 2.0 * R, "cm");
  problems.require(
      commissure_z + kAscendingTransition <= root.length - 1.0, "domain.size_cm",
      fmt::format("found a length of {:.6g} cm, but the tube reaches its ascending radius at {:.6g} cm "
                  "and the outlet's flare needs one more.",
                  root.length, commissure_z + kAscendingTransition));
  problems.require_between("root.end_flare_spacings", root.end_flare_spacings, 0.0, 10.0, "grid spacings");
}

}  // namespace

LeafletMaterial scaled(const LeafletMaterial& common, const LeafletFactors& factors)
{
  LeafletMaterial one = common;
  one.circumferential_stiffness *= factors.stiffness;
  one.radial_stiffness *= factors.stiffness;
  one.circumferential_bending *= factors.bending;
  one.radial_bending *= factors.bending;
  one.radial_rest_ratio *= factors.height;
  one.free_edge_rest_ratio *= factors.free_edge;
  return one;
}

std::vector<CaseProblem> root_problems(const RootDimensions& root, const LeafletMaterial& leaflets,
                                       const WallMaterial& wall, double h)
{
  Problems problems;
  check_dimensions(root, h, problems);
  problems.require_between("leaflets.circumferential_stiffness_dyn_cm", leaflets.circumferential_stiffness,
                           1e4, 1e9, "dyn/cm");
  problems.require_between("leaflets.radial_stiffness_dyn_cm", leaflets.radial_stiffness, 1e3, 1e9, "dyn/cm");
  problems.require_between("leaflets.bending_rows_dyn_cm", leaflets.circumferential_bending, 0.0, 1e5,
                           "dyn cm");
  problems.require_between("leaflets.bending_columns_dyn_cm", leaflets.radial_bending, 0.0, 1e5, "dyn cm");
  problems.require_between("leaflets.belly_ratio", leaflets.circumferential_rest_ratio, 0.7, 1.3,
                           "of the length on the tube");
  problems.require_between("leaflets.free_edge_ratio", leaflets.free_edge_rest_ratio, 0.7, 1.3,
                           "of the length on the tube");
  problems.require_between("leaflets.radial_ratio", leaflets.radial_rest_ratio, 0.8, 1.4,
                           "of the length on the tube");
  problems.require_between("leaflets.edge_tether_dyn_cm3", leaflets.edge_tether_ratio * wall.tether_stiffness,
                           0.0, 1e12, "dyn/cm^3");
  problems.require_between("leaflets.start_pressure_mmHg", leaflets.start_pressure_mmHg, 1.0, 120.0, "mmHg");
  problems.require_between("wall.tether_dyn_cm3", wall.tether_stiffness, 1e4, 1e10, "dyn/cm^3");
  problems.require_between("wall.layers", wall.layers, 1, 9, "");
  problems.require_between("wall.spacing_h", wall.node_spacing_ratio, 0.2, 1.0, "grid spacings");
  return problems.take();
}

}  // namespace valsalva::ib3d
