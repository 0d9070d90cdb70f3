#include "setup/checks.hpp"

#include <fmt/format.h>

#include "setup/aortic_valve.hpp"
#include "setup/marker_seeds.hpp"

namespace valsalva::setup {

namespace {

using Problems = std::vector<CaseProblem>;

void add(Problems& problems, const std::string& key, const std::string& message)
{
  problems.push_back({"", 0, 0, key, message});
}

void check_time(const Case& c, Problems& problems)
{
  const bool has_period = c.time.period_s > 0;
  if (c.time.stop_when_periodic_within > 0 && !has_period)
    add(problems, "time.stop_when_periodic_within",
        "compares beats, but without time.period_s the whole run is one beat; set time.period_s, e.g. 0.8, "
        "or "
        "remove this key");
  if (c.time.start == Start::periodic && !has_period)
    add(problems, "time.start", "is \"periodic\", but time.period_s is 0; set it to the length of a beat");
}

/// A 0D case has nothing but its network, and beats only where there is a valve.
void check_lumped(const Case& c, Problems& problems)
{
  if (c.time.stop_when_periodic_within > 0 && find_aortic_valve(c.network).flow.empty())
    add(problems, "time.stop_when_periodic_within",
        "compares beats, but the case has no valve from which beats are measured; remove this key");
  const std::string needs = "needs a 3D run, but the case has no [[opening]]; add one, or ";
  if (c.structure.kind != StructureKind::none) add(problems, "structure.kind", needs + "set kind = \"none\"");
  for (const Refine& r : c.refine) add(problems, "refine." + r.name, needs + "remove this");
  for (const MarkerGroup& m : c.markers) add(problems, "markers." + m.name, needs + "remove this");
}

void check_grid(const Case& c, Problems& problems)
{
  const ib3d::RefinementPolicy& policy = c.grid.refinement;
  if (policy.vorticity > 0 && policy.levels == 1)
    add(problems, "grid.vorticity_1_s", "refines, but grid.levels is 1; use more levels");
  if (c.pressure.solver == "pfmg" && policy.levels > 1)
    add(problems, "pressure.solver",
        "is \"pfmg\", which handles one level only; use \"multilevel\" or grid.levels = 1");
  try {
    c.finest_spacing();
  } catch (const CaseError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  for (const Refine& r : c.refine) {
    if (r.region.level >= policy.levels)
      add(problems, "refine." + r.name + ".level",
          fmt::format("is {}, but grid.levels = {} ends with level {}", r.region.level, policy.levels,
                      policy.levels - 1));
    for (int d = 0; d < 3; ++d)
      if (r.region.lo[d] >= r.region.hi[d]) {
        add(problems, "refine." + r.name + ".lo_cm", "must lie below hi_cm in every direction");
        break;
      }
  }
}

void check_openings(const Case& c, Problems& problems)
{
  for (std::size_t n = 0; n < c.openings.size(); ++n) {
    const ib3d::Opening& o = c.openings[n];
    for (int d : {ib3d::first_tangent(o.side), ib3d::second_tangent(o.side)})
      if (o.centre[d] - o.radius < 0 || o.centre[d] + o.radius > c.domain.size[d])
        add(problems, "opening." + o.name + ".radius_cm",
            fmt::format(
                "puts the disc outside the box: it reaches from {:.4g} to {:.4g} cm along {}, the box from 0 "
                "to {:.4g} cm; use a smaller disc or a larger domain.size_cm",
                o.centre[d] - o.radius, o.centre[d] + o.radius, "xyz"[d], c.domain.size[d]));
    for (std::size_t m = 0; m < n; ++m) {
      const ib3d::Opening& other = c.openings[m];
      if (other.side == o.side && norm(other.centre - o.centre) < other.radius + o.radius)
        add(problems, "opening." + o.name + ".center_cm",
            fmt::format("lets the disc overlap that of opening \"{}\"", other.name));
    }
  }
}

}  // namespace

std::vector<CaseProblem> problems_of(const Case& c)
{
  Problems problems;
  check_time(c, problems);
  if (c.is_lumped()) {
    check_lumped(c, problems);
    return problems;
  }
  check_grid(c, problems);
  check_openings(c, problems);
  if (problems.empty()) problems = marker_problems(c);
  if (problems.empty() && c.structure.kind == StructureKind::aortic_root) problems = root_problems(c);
  if (c.structure.kind == StructureKind::files && c.structure.files_prefix.empty())
    add(problems, "structure.files_prefix",
        "is empty; name the fibre files, for instance \"valve\" for valve.vertex");
  return problems;
}

}  // namespace valsalva::setup
