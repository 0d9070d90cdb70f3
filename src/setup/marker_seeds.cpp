#include "setup/marker_seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ib3d/structure/aortic_root/root_shape.hpp"

namespace valsalva::setup {

namespace {

/// Of the narrowest opening; 0 where there is an aortic root, whose lumen is known.
double radius_without_root(const Case& c)
{
  if (c.structure.kind == StructureKind::aortic_root) return 0;
  double narrowest = 0;
  for (const ib3d::Opening& o : c.openings)
    narrowest = narrowest > 0 ? std::min(narrowest, o.radius) : o.radius;
  return narrowest;
}

/// What a group says about its planes; the radius is that of the disc, or of the lumen at an angle and a height.
struct Planes {
  Planes(const Case& c, const MarkerGroup& group)
      : root(c.structure.root),
        spacing(group.spacing_cm),
        disc_radius(group.radius_cm > 0 ? group.radius_cm : radius_without_root(c)),
        wall_spacing(c.finest_spacing()),
        heights(group.z_cm),
        centre(group.centre_cm ? *group.centre_cm : std::array{root.centre[0], root.centre[1]})
  {
  }
  double radius(double angle, double z) const
  {
    // a wall keeps what lies within a cell of it
    return disc_radius > 0 ? disc_radius : ib3d::wall_radius(root, wall_spacing, angle, z) - wall_spacing;
  }
  double largest_radius() const
  {
    double largest = disc_radius;
    for (double z : heights)
      for (int sixth = 0; sixth < 6; ++sixth)
        largest = std::max(largest, radius(sixth * std::numbers::pi / 3, z));
    return largest;
  }
  std::vector<Vec3> points() const
  {
    std::vector<Vec3> all;
    const int n = static_cast<int>(largest_radius() / spacing);
    for (double z : heights)
      for (int j = -n; j <= n; ++j)
        for (int i = -n; i <= n; ++i)
          if (std::hypot(i, j) * spacing <= radius(std::atan2(j, i), z))
            all.push_back({centre[0] + i * spacing, centre[1] + j * spacing, z});
    return all;
  }

  ib3d::RootDimensions root;
  double spacing, disc_radius, wall_spacing;
  const std::vector<double>& heights;
  std::array<double, 2> centre;
};

}  // namespace

std::vector<CaseProblem> marker_problems(const Case& c)
{
  std::vector<CaseProblem> problems;
  for (const MarkerGroup& group : c.markers) {
    const auto add = [&](const std::string& key, const std::string& message) {
      problems.push_back({"", 0, 0, "markers." + group.name + "." + key, message});
    };
    if (group.end_s < group.start_s)
      add("end_s",
          fmt::format("is {:g} s, before start_s = {:g} s; use a later end", group.end_s, group.start_s));
    for (double z : group.z_cm)
      if (z > c.domain.size[2])
        add("z_cm",
            fmt::format("has a plane at {:g} cm, but the box ends at {:g} cm; use heights inside the box", z,
                        c.domain.size[2]));
    const Planes planes(c, group);
    if (planes.disc_radius == 0 && !group.centre_cm) continue;  // inside the wall, which must lie in the box
    const double reach = planes.largest_radius();
    for (std::size_t d = 0; d < 2; ++d)
      if (const double size = c.domain.size[static_cast<int>(d)];
          planes.centre[d] < reach || planes.centre[d] + reach > size)
        add("radius_cm",
            fmt::format("puts markers outside the box: they would reach from {:.4g} to {:.4g} cm along "
                        "{}, the box from 0 to {:.4g} cm; use a smaller disc",
                        planes.centre[d] - reach, planes.centre[d] + reach, "xy"[d], size));
  }
  return problems;
}

std::vector<ib3d::MarkerSeed> marker_seeds(const Case& c)
{
  std::vector<ib3d::MarkerSeed> seeds;
  for (const MarkerGroup& group : c.markers)
    seeds.push_back({group.name, Planes(c, group).points(), group.start_s, group.every_s, group.end_s});
  return seeds;
}

}  // namespace valsalva::setup
