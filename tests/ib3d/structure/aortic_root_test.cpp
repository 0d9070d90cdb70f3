#include "ib3d/structure/aortic_root/aortic_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "common/error.hpp"
#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "ib3d/structure/aortic_root/root_wall.hpp"
#include "ib3d/structure/fibres/fibre_strain.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kH = 10.0 / 64;
constexpr double kThird = 2.0 * std::numbers::pi / 3.0;
const RootDimensions kRoot;

const FibreNetwork& whole_root()
{
  static const FibreNetwork network = build_aortic_root(kRoot, LeafletMaterial{}, WallMaterial{}, kH);
  return network;
}

Vec3 turned(const Vec3& x, double angle)
{
  const double dx = x[0] - kRoot.centre[0], dy = x[1] - kRoot.centre[1];
  return {kRoot.centre[0] + std::cos(angle) * dx - std::sin(angle) * dy,
          kRoot.centre[1] + std::sin(angle) * dx + std::cos(angle) * dy, x[2]};
}

double radius_of(const Vec3& x)
{
  return std::hypot(x[0] - kRoot.centre[0], x[1] - kRoot.centre[1]);
}

double angle_of(const Vec3& x)
{
  return std::atan2(x[1] - kRoot.centre[1], x[0] - kRoot.centre[0]);
}

TEST(AorticRoot, HasThreeLeafletsAndThreeWallLayersThatCoverAllNodes)
{
  const FibreNetwork& network = whole_root();
  const std::vector<std::string> names{"leaflet 1", "leaflet 2", "leaflet 3", "wall 1", "wall 2", "wall 3"};
  ASSERT_EQ(network.groups.size(), names.size());
  int next = 0;
  for (std::size_t n = 0; n < names.size(); ++n) {
    EXPECT_EQ(network.groups[n].name, names[n]);
    EXPECT_EQ(network.groups[n].first, next);
    next = network.groups[n].last;
  }
  EXPECT_EQ(next, network.node_count());
}

TEST(AorticRoot, LeafletsAreRotationsOfOne)
{
  const FibreNetwork& network = whole_root();
  const NodeGroup& one = network.groups[0];
  for (int k : {1, 2}) {
    const NodeGroup& other = network.groups[static_cast<std::size_t>(k)];
    ASSERT_EQ(other.last - other.first, one.last - one.first);
    for (int i = one.first; i < one.last; ++i)
      ASSERT_LT(norm(turned(network.X[static_cast<std::size_t>(i)], k * kThird) -
                     network.X[static_cast<std::size_t>(i - one.first + other.first)]),
                1e-12);
  }
}

TEST(AorticRoot, WallIsThreefoldSymmetric)
{
  const WallLayer layer = wall_layer(kRoot, kH, 0.5 * kH, 0.6 * kH);
  std::size_t first = 0;
  while (first < layer.X.size()) {
    std::size_t last = first;
    while (last < layer.X.size() && layer.X[last][2] == layer.X[first][2]) ++last;
    const std::size_t count = last - first;
    ASSERT_EQ(count % 3, 0u);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t image = first + (k + count / 3) % count;
      ASSERT_LT(norm(turned(layer.X[first + k], kThird) - layer.X[image]), 1e-12);
      ASSERT_NEAR(layer.area[first + k], layer.area[image], 1e-6 * layer.area[image]);
    }
    first = last;
  }
}

/// Area of the inner wall by a fine triangulation of its own.
double triangulated_wall_area()
{
  const int around = 360, along = 1500;
  const auto point = [&](int i, int j) {
    const double theta = 3.0 * kThird * i / around, z = kRoot.length * j / along;
    const double r = wall_radius(kRoot, kH, theta, z);
    return Vec3{r * std::cos(theta), r * std::sin(theta), z};
  };
  double area = 0.0;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
      area += 0.5 * norm(cross(point(i + 1, j + 1) - point(i, j), point(i, j + 1) - point(i + 1, j)));
  return area;
}

TEST(AorticRoot, WallNodeAreasSumToTheTubesArea)
{
  const WallLayer layer = wall_layer(kRoot, kH, 0.0, 0.6 * kH);
  double sum = 0.0;
  for (double area : layer.area) sum += area;
  const double exact = triangulated_wall_area();
  EXPECT_NEAR(sum, exact, 0.01 * exact);
}

TEST(AorticRoot, WallReachesBothEndsAndFlaresThere)
{
  const WallLayer layer = wall_layer(kRoot, kH, 0.0, 0.6 * kH);
  EXPECT_EQ(layer.X.front()[2], 0.0);
  EXPECT_EQ(layer.X.back()[2], kRoot.length);
  EXPECT_NEAR(radius_of(layer.X.front()), kRoot.annulus_radius + 1.75 * kH, 1e-12);
  EXPECT_NEAR(radius_of(layer.X.back()), kRoot.ascending_radius + 1.75 * kH, 1e-12);
}

TEST(AorticRoot, LayersLieHalfAGridSpacingApart)
{
  const FibreNetwork& network = whole_root();
  for (int layer = 0; layer < 3; ++layer) {
    const std::string name = "wall " + std::to_string(layer + 1);
    const auto group = std::find_if(network.groups.begin(), network.groups.end(),
                                    [&](const NodeGroup& g) { return g.name == name; });
    ASSERT_NE(group, network.groups.end());
    for (int i = group->first; i < group->last; i += 97) {
      const Vec3 x = network.X[static_cast<std::size_t>(i)];
      EXPECT_NEAR(radius_of(x), wall_radius(kRoot, kH, angle_of(x), x[2]) + 0.5 * kH * layer, 1e-9);
    }
  }
}

TEST(AorticRoot, SinusBeginsOnTheAttachmentLine)
{
  for (double s : {0.0, 0.4, 0.9, 1.1}) {
    const double z = kRoot.annulus_z + attachment_height(kRoot, s), theta = s / kRoot.annulus_radius;
    EXPECT_NEAR(wall_radius(kRoot, kH, theta, z), kRoot.annulus_radius, 1e-12);
    EXPECT_GT(wall_radius(kRoot, kH, theta + kThird, z + 0.1), kRoot.annulus_radius);
    EXPECT_NEAR(attachment_half_width(kRoot, attachment_height(kRoot, s)), s, 1e-7);
  }
}

TEST(AorticRoot, LeafletEdgesAreTetheredOnTheTubeAndTheRestIsInside)
{
  const FibreNetwork& network = whole_root();
  const std::set<int> tethered(network.tethers.node.begin(), network.tethers.node.end());
  for (int i = 0; i < network.groups[2].last; ++i) {
    const Vec3 x = network.X[static_cast<std::size_t>(i)];
    if (tethered.count(i) > 0) {
      EXPECT_NEAR(radius_of(x), kRoot.annulus_radius, 1e-12);
    } else {
      EXPECT_LT(radius_of(x), wall_radius(kRoot, kH, angle_of(x), x[2]));
    }
  }
  EXPECT_EQ(largest_tether_displacement(network, network.X), 0.0);
}

TEST(AorticRoot, FreeEdgesRunFromCommissureToCommissure)
{
  const FibreNetwork& network = whole_root();
  const std::set<int> tethered(network.tethers.node.begin(), network.tethers.node.end());
  ASSERT_EQ(network.free_edges.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<int>& edge = network.free_edges[k];
    for (const auto& [node, side] : {std::pair{edge.front(), -0.5}, std::pair{edge.back(), 0.5}}) {
      const double angle = (static_cast<double>(k) + side) * kThird;
      const Vec3 commissure{kRoot.centre[0] + kRoot.annulus_radius * std::cos(angle),
                            kRoot.centre[1] + kRoot.annulus_radius * std::sin(angle),
                            kRoot.annulus_z + kRoot.commissure_height};
      EXPECT_LT(norm(network.X[static_cast<std::size_t>(node)] - commissure), 1e-12);
      EXPECT_EQ(tethered.count(node), 1u);
    }
    for (std::size_t n = 1; n + 1 < edge.size(); ++n) {
      EXPECT_EQ(tethered.count(edge[n]), 0u);
      EXPECT_LT(norm(network.X[static_cast<std::size_t>(edge[n])] -
                     network.X[static_cast<std::size_t>(edge[n - 1])]),
                kH);
    }
  }
}

}  // namespace
}  // namespace valsalva::ib3d
