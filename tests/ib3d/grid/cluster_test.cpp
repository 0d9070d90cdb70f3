// Tags become few disjoint boxes that hold them, and levels nest.
#include "ib3d/grid/cluster.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ib3d/fluid/tube.hpp"
#include "ib3d/grid/refinement.hpp"

namespace valsalva::ib3d {
namespace {

bool disjoint(const std::vector<IndexBox>& boxes)
{
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (!intersect(boxes[a], boxes[b]).empty()) return false;
  return true;
}

TEST(Cluster, TaggedTilesAreHeldByDisjointFullBoxes)
{
  Tiles tags({{0, 0, 0}, {80, 80, 80}});
  long tagged = 0;
  for_each_index(tags.box(), [&](int i, int j, int k) {
    const double r = std::hypot(i - 4.5, j - 4.5, k - 4.5);
    if (r < 4.2 && r > 2.5) {
      tags.set(i, j, k);
      ++tagged;
    }
  });
  const std::vector<IndexBox> boxes = cluster(tags, 0.8);
  EXPECT_TRUE(disjoint(boxes));
  long held = 0, volume = 0;
  for (const IndexBox& b : boxes) {
    volume += b.volume();
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(b.lo[d] % kBlockingFactor + b.hi[d] % kBlockingFactor, 0);
    for_each_index({{b.lo[0] / 8, b.lo[1] / 8, b.lo[2] / 8}, {b.hi[0] / 8, b.hi[1] / 8, b.hi[2] / 8}},
                   [&](int i, int j, int k) { held += tags(i, j, k) ? 1 : 0; });
  }
  EXPECT_EQ(held, tagged);
  EXPECT_GE(static_cast<double>(512 * tagged), 0.8 * static_cast<double>(volume));
}

TEST(Cluster, ABlockOfTagsIsOneBox)
{
  Tiles tags({{0, 0, 0}, {64, 64, 128}});
  tags.add({{9, 17, 30}, {40, 41, 90}}, walled_box({1, 1, 2}));
  const std::vector<IndexBox> boxes = cluster(tags);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0], (IndexBox{{8, 16, 24}, {40, 48, 96}}));
}

TEST(Cluster, WhatATubeEnclosesIsFilled)
{
  Tiles tags({{0, 0, 0}, {64, 64, 8}});
  for (int i = 2; i <= 5; ++i)
    for (int j = 2; j <= 5; ++j)
      if (i == 2 || i == 5 || j == 2 || j == 5) tags.set(i, j, 0);
  tags.fill_enclosed();
  EXPECT_TRUE(tags(3, 4, 0));
  EXPECT_FALSE(tags(1, 4, 0));
  EXPECT_FALSE(tags(6, 6, 0));
}

TEST(Refine, LevelsNestAndHoldTheNodesWithTheirSupport)
{
  const Domain domain = walled_box({4, 4, 4});
  const double h = 4.0 / 128;
  std::vector<Vec3> nodes;
  for (int n = 0; n < 200; ++n) nodes.push_back({2 + std::sin(0.1 * n), 2 + std::cos(0.1 * n), 0.02 * n});
  RefinementPolicy policy;
  policy.levels = 3;
  const Refinement boxes = refine(domain, h, policy, nodes);
  ASSERT_EQ(boxes.size(), 2u);
  const auto covered = [](const IndexBox& wanted, const std::vector<IndexBox>& by) {
    std::vector<IndexBox> rest{wanted};
    for (const IndexBox& b : by) rest = without(rest, b);
    return rest.empty();
  };
  for (const Vec3& x : nodes) {
    IndexBox support;
    for (std::size_t d = 0; d < 3; ++d) {
      const int cell = static_cast<int>(std::floor(x[static_cast<int>(d)] / h));
      support.lo[d] = std::max(0, cell - kSupportCells - policy.margin_cells);
      support.hi[d] = std::min(128, cell + kSupportCells + policy.margin_cells + 1);
    }
    EXPECT_TRUE(covered(support, boxes[1]));
  }
  for (const IndexBox& fine : boxes[1])
    EXPECT_TRUE(
        covered(intersect(fine.coarsened().grown(kNestingBuffer), {{0, 0, 0}, {64, 64, 64}}), boxes[0]));
  EXPECT_TRUE(disjoint(boxes[0]));
  EXPECT_TRUE(disjoint(boxes[1]));
}

}  // namespace
}  // namespace valsalva::ib3d
