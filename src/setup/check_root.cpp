#include <fmt/format.h>

#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "setup/checks.hpp"

namespace valsalva::setup {

namespace {

class RootProblems {
 public:
  void require(bool holds, const std::string& key, const std::string& message)
  {
    if (!holds) found_.push_back(CaseProblem{"", 0, 0, key, message});
  }
  void require_between(const std::string& key, double value, double low, double high)
  {
    require(value >= low && value <= high, key,
            fmt::format("is {:.6g} cm, but for this annulus and box it must lie between {:.6g} and {:.6g} cm",
                        value, low, high));
  }
  std::vector<CaseProblem> take() { return std::move(found_); }

 private:
  std::vector<CaseProblem> found_;
};

/// Both ends of the tube flare over their last centimetre.
constexpr double kFlareLength = 1.0;

}  // namespace

std::vector<CaseProblem> root_problems(const Case& c)
{
  const ib3d::RootDimensions& root = c.structure.root;
  const double R = root.annulus_radius, h = c.grid.finest_cm;
  const double commissure_z = root.annulus_z + root.commissure_height;
  const double outlet_flare_z = root.length - kFlareLength;
  RootProblems problems;
  problems.require(
      h <= R / 4.0, "grid.finest_cm",
      fmt::format("is {:.6g} cm, but an annulus of radius {:.6g} cm needs a spacing of at most a "
                  "quarter of it; refine the grid",
                  h, R));
  problems.require_between("root.annulus_z_cm", root.annulus_z, kFlareLength, root.length);
  problems.require_between("root.commissure_height_cm", root.commissure_height, 0.5 * R, 2.5 * R);
  problems.require(
      root.sinus_end_z >= commissure_z + 0.1, "root.sinus_end_z_cm",
      fmt::format("is {:.6g} cm, but the sinuses must end at least 0.1 cm beyond the commissures at "
                  "annulus_z_cm + commissure_height_cm = {:.6g} cm",
                  root.sinus_end_z, commissure_z));
  problems.require(
      root.sinus_end_z <= outlet_flare_z, "root.sinus_end_z_cm",
      fmt::format("is {:.6g} cm, but the sinuses must end before the flare of the outlet begins at "
                  "{:.6g} cm",
                  root.sinus_end_z, outlet_flare_z));
  problems.require_between("root.sinus_bulge_cm", root.sinus_bulge, 0.0, R);
  problems.require_between("root.ascending_radius_cm", root.ascending_radius, 0.5 * R, 2.0 * R);
  problems.require(
      commissure_z + ib3d::kAscendingTransition <= outlet_flare_z, "domain.size_cm",
      fmt::format("gives the tube a length of {:.6g} cm, but it reaches its ascending radius at {:.6g} "
                  "cm and the flare of the outlet needs one more",
                  root.length, commissure_z + ib3d::kAscendingTransition));
  return problems.take();
}

}  // namespace valsalva::setup
