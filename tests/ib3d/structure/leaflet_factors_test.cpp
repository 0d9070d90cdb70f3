// Single leaflets that differ from the others: stiffer, shorter, grown to their neighbours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ib3d/structure/aortic_root/aortic_root.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kH = 10.0 / 48;
const RootDimensions kRoot;
const LeafletMaterial kMaterial;

AorticRoot designed(const std::array<LeafletFactors, 3>& factors)
{
  return design_aortic_root(kRoot, kMaterial, WallMaterial{}, kH, factors);
}

const AorticRoot& normal_root()
{
  static const AorticRoot root = designed({});
  return root;
}

const Vec3& at(const FibreNetwork& network, int node)
{
  return network.X[static_cast<std::size_t>(node)];
}

double distance_from_axis(const Vec3& x)
{
  return std::hypot(x[0] - kRoot.centre[0], x[1] - kRoot.centre[1]);
}

/// Distance of the middle of a leaflet's free edge from the axis, cm.
double reach(const FibreNetwork& network, std::size_t leaflet)
{
  const std::vector<int>& edge = network.free_edges[leaflet];
  return distance_from_axis(at(network, edge[edge.size() / 2]));
}

TEST(LeafletFactors, LeaveTheOtherLeafletsAndTheWallAsTheyAre)
{
  std::array<LeafletFactors, 3> factors;
  factors[1].height = 0.8;
  const AorticRoot changed = designed(factors);
  const FibreNetwork &now = changed.network, &normal = normal_root().network;
  ASSERT_EQ(now.groups.size(), normal.groups.size());
  for (std::size_t g = 0; g < normal.groups.size(); ++g) {
    const NodeGroup &a = now.groups[g], &b = normal.groups[g];
    const bool same = a.last - a.first == b.last - b.first &&
                      std::equal(now.X.begin() + a.first, now.X.begin() + a.last, normal.X.begin() + b.first);
    EXPECT_EQ(same, g != 1) << normal.groups[g].name;
  }
}

TEST(LeafletFactors, ATwiceAsStiffLeafletIsStrainedLess)
{
  std::array<LeafletFactors, 3> factors;
  factors[2].stiffness = 2.0;
  const AorticRoot root = designed(factors);
  const double normal = root.closed[1].circumferential_strain_mean;
  EXPECT_EQ(root.closed[0].circumferential_strain_mean, normal);
  EXPECT_GT(root.closed[2].circumferential_strain_mean, 0.4 * normal);
  EXPECT_LT(root.closed[2].circumferential_strain_mean, 0.7 * normal);
}

TEST(LeafletFactors, ALeafletThatResistsBendingCoaptsLess)
{
  std::array<LeafletFactors, 3> factors;
  for (LeafletFactors& f : factors) f.bending = 20.0;
  EXPECT_LT(designed(factors).closed[0].coaptation_height_cm,
            0.5 * normal_root().closed[0].coaptation_height_cm);
}

TEST(LeafletFactors, ARetractedLeafletLeavesAGapThatTheOthersDoNotFill)
{
  std::array<LeafletFactors, 3> factors;
  factors[0].height = 0.75;
  factors[0].free_edge = 0.9;
  const AorticRoot root = designed(factors);
  EXPECT_EQ(root.closed[0].coaptation_height_cm, 0.0);
  EXPECT_GT(root.closed[1].coaptation_height_cm, 0.3);
  EXPECT_LT(root.closed[0].middle_length_cm, 0.9 * root.closed[1].middle_length_cm);
  EXPECT_GT(reach(root.network, 0), 0.2 * kRoot.annulus_radius);
  EXPECT_LT(reach(root.network, 1), 0.1 * kRoot.annulus_radius);
}

TEST(LeafletFactors, FusedLeafletsAreJoinedToTheirMirrorImagesBetweenThemOnly)
{
  std::array<LeafletFactors, 3> factors;
  factors[0].fused_share = 0.5;
  const FibreNetwork root = designed(factors).network;
  const FibreNetwork& normal = normal_root().network;
  const auto first = static_cast<std::size_t>(normal.springs.count());
  ASSERT_GT(root.springs.count(), normal.springs.count());
  const double angle = std::numbers::pi / 3;  // the commissure between leaflets 1 and 2
  const Vec3 across{-std::sin(angle), std::cos(angle), 0.0};
  for (std::size_t n = first; n < root.springs.a.size(); ++n) {
    const Vec3 a = at(root, root.springs.a[n]), b = at(root, root.springs.b[n]);
    EXPECT_LT(root.springs.a[n], root.groups[0].last);
    EXPECT_GE(root.springs.b[n], root.groups[1].first);
    EXPECT_LT(root.springs.b[n], root.groups[1].last);
    EXPECT_LT(norm(a - b), 0.06) << "both are held at the gap from the plane between them";
    EXPECT_LT(norm(a - b - dot(a - b, across) * across), 1e-6) << "mirror images";
    EXPECT_DOUBLE_EQ(root.springs.rest_length[n], norm(a - b)) << "slack at the start";
  }
}

TEST(LeafletFactors, TheFusedPartOfTheFreeEdgeGrowsWithTheShare)
{
  const auto joined_on_edge = [](double share) {
    std::array<LeafletFactors, 3> factors;
    factors[0].fused_share = share;
    const FibreNetwork root = designed(factors).network;
    const std::vector<int>& edge = root.free_edges[0];
    double joined = 0;
    for (std::size_t n = static_cast<std::size_t>(normal_root().network.springs.count());
         n < root.springs.a.size(); ++n)
      joined += std::count(edge.begin(), edge.end(), root.springs.a[n]) > 0 ? 1 : 0;
    return joined / (0.5 * static_cast<double>(edge.size() - 2));
  };
  EXPECT_NEAR(joined_on_edge(0.3), 0.3, 0.1);
  EXPECT_NEAR(joined_on_edge(0.6), 0.6, 0.1);
  EXPECT_NEAR(joined_on_edge(1.0), 1.0, 0.1);
}

}  // namespace
}  // namespace valsalva::ib3d
