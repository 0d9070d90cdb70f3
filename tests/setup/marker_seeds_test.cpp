// Where the markers of a case set out.
#include "setup/marker_seeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "common/max_or_nan.hpp"
#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "setup/read_case.hpp"

namespace valsalva::setup {

namespace {

Case root_case(const std::vector<std::string>& overrides)
{
  const auto file = std::filesystem::path(VALSALVA_SOURCE_DIR) / "cases/aortic_root/case.toml";
  return read_case(file.string(), overrides);
}

TEST(MarkerSeeds, FillTheLumenOfTheRootACellShortOfTheWall)
{
  const double h = 0.15625, spacing = 0.05;
  const Case c =
      root_case({"markers.aorta.z_cm=[1.5, 4.2]", "markers.aorta.spacing_cm=0.05", "grid.finest_cm=0.15625"});
  const ib3d::RootDimensions root = c.structure.root;
  const std::vector<ib3d::MarkerSeed> seeds = marker_seeds(c);
  ASSERT_EQ(seeds.size(), 3U);
  EXPECT_EQ(seeds[1].name, "aorta");
  double area[2] = {0, 0}, furthest = -1e9, tube = root.annulus_radius - h;
  for (const Vec3& X : seeds[1].points) {
    const double x = X[0] - root.centre[0], y = X[1] - root.centre[1];
    furthest = max_or_nan(furthest, std::hypot(x, y) - ib3d::wall_radius(root, h, std::atan2(y, x), X[2]));
    area[X[2] < 2 ? 0 : 1] += spacing * spacing;
  }
  EXPECT_LE(furthest, -h + 1e-12);
  EXPECT_NEAR(area[0], M_PI * tube * tube, 0.06);
  EXPECT_GT(area[1], area[0] + 0.5);  // the sinuses are wider than the tube
}

TEST(MarkerSeeds, LieInDiscsOfAGivenRadiusAboutAGivenCentre)
{
  const Case c = root_case({"markers.aorta.z_cm=[1.5, 7.0]", "markers.aorta.spacing_cm=0.1",
                            "markers.aorta.radius_cm=0.5", "markers.aorta.center_cm=[1.0, 2.0]"});
  const ib3d::MarkerSeed seed = marker_seeds(c)[1];
  EXPECT_EQ(seed.points.size(), 2 * 81U);  // lattice points within a circle of radius five
  for (const Vec3& X : seed.points) EXPECT_LE(std::hypot(X[0] - 1, X[1] - 2), 0.5 + 1e-12);
  EXPECT_EQ(seed.points.front()[2], 1.5);
  EXPECT_EQ(seed.points.back()[2], 7.0);
}

TEST(MarkerSeeds, WithoutAnAorticRootADiscIsAsWideAsTheNarrowestOpening)
{
  const Case c = root_case({"structure.kind=\"none\"", "markers.aorta.z_cm=[7.0]",
                            "markers.aorta.spacing_cm=0.05", "opening.inlet.radius_cm=0.8"});
  const ib3d::MarkerSeed seed = marker_seeds(c)[1];
  double furthest = 0;
  for (const Vec3& X : seed.points) furthest = max_or_nan(furthest, std::hypot(X[0] - 2.5, X[1] - 2.5));
  EXPECT_NEAR(furthest, 0.8, 0.051);
}

}  // namespace
}  // namespace valsalva::setup
