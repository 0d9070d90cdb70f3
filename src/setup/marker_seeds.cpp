#include "setup/marker_seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"
#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "setup/build_model.hpp"

namespace valsalva::setup {

namespace {

/// Of the narrowest opening; 0 where there is an aortic root, whose lumen is known.
double radius_without_root(const CaseFile& c, const ib3d::Domain& domain)
{
  if (c.section("structure").text("kind") == "aortic_root") return 0;
  double narrowest = 0;
  for (const ib3d::Opening& o : openings_from_case(c, domain))
    narrowest = narrowest > 0 ? std::min(narrowest, o.radius) : o.radius;
  return narrowest;
}

/// What an entry says about its planes; the radius is that of the disc, or of the lumen at an angle and a height.
struct Planes {
  Planes(const CaseFile& c, const CaseTable& t, const ib3d::Domain& domain, double h)
      : root(root_dimensions_from_case(c, domain)),
        spacing(t.real("spacing_cm")),
        disc_radius(t.real("radius_cm") > 0 ? t.real("radius_cm") : radius_without_root(c, domain)),
        wall_spacing(h),
        heights(t.reals("z_cm")),
        centre(t.has("center_cm") ? t.reals("center_cm") : c.section("root").reals("center_cm"))
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
  const std::vector<double>& centre;
};

}  // namespace

std::vector<ib3d::MarkerSeed> marker_seeds_from_case(const CaseFile& c, const ib3d::Domain& domain, double h)
{
  std::vector<ib3d::MarkerSeed> seeds;
  std::vector<CaseProblem> problems;
  for (const CaseTable& t : c.tables("markers")) {
    ib3d::MarkerSeed seed{t.text("name"), {}, t.real("start_s"), t.real("every_s")};
    if (t.has("end_s")) seed.end_s = t.real("end_s");
    if (seed.end_s < seed.start_s)
      problems.push_back(t.problem("end_s", fmt::format("is {:g} s, before start_s = {:g} s; use a later end",
                                                        seed.end_s, seed.start_s)));
    for (double z : t.reals("z_cm"))
      if (z > domain.size[2])
        problems.push_back(
            t.problem("z_cm", fmt::format("has a plane at {:g} cm, but the box ends at {:g} cm; "
                                          "use heights inside the box",
                                          z, domain.size[2])));
    const Planes planes(c, t, domain, h);
    const double reach = planes.largest_radius();
    for (std::size_t d = 0; d < 2; ++d)
      if (planes.centre[d] < reach || planes.centre[d] + reach > domain.size[static_cast<int>(d)])
        problems.push_back(t.problem(
            "radius_cm",
            fmt::format("puts markers outside the box: they would reach from {:.4g} to {:.4g} cm along "
                        "{}, the box from 0 to {:.4g} cm; use a smaller disc",
                        planes.centre[d] - reach, planes.centre[d] + reach, "xy"[d],
                        domain.size[static_cast<int>(d)])));
    if (problems.empty()) seed.points = planes.points();
    seeds.push_back(std::move(seed));
  }
  if (!problems.empty()) throw CaseError(problems);
  return seeds;
}

}  // namespace valsalva::setup
