// Parts of a fibre model: what one rank computes of the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "ib3d/structure/fibres/fibre_model.hpp"
#include "random_network.hpp"

namespace valsalva::ib3d {
namespace {

std::vector<std::vector<int>> shuffled_thirds(int nodes)
{
  std::vector<int> order(static_cast<std::size_t>(nodes));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 generator(17);
  std::shuffle(order.begin(), order.end(), generator);
  std::vector<std::vector<int>> thirds(3);
  for (std::size_t n = 0; n < order.size(); ++n) thirds[n % 3].push_back(order[n]);
  return thirds;
}

std::vector<Vec3> taken(const std::vector<Vec3>& all, const std::vector<int>& nodes)
{
  std::vector<Vec3> some;
  for (int node : nodes) some.push_back(all[static_cast<std::size_t>(node)]);
  return some;
}

TEST(FibreModel, PartsReproduceForcesStiffnessAndSlipOfTheWholeToTheLastBit)
{
  const FibreModel whole(random_network(60, 21), 0.1);
  const std::vector<Vec3> X = random_vectors(60, 22), v = random_vectors(60, 23);
  const auto all = [&](const ElasticModel& model, const std::vector<Vec3>& at,
                       const std::vector<Vec3>& moved) {
    std::array<std::vector<Vec3>, 3> values;
    values.fill(std::vector<Vec3>(at.size(), Vec3{0, 0, 0}));
    model.add_force(at, values[0]);
    model.add_stiffness_times(at, moved, values[1]);
    model.add_slip(at, 0.2, values[2]);
    return values;
  };
  const auto expected = all(whole, X, v);
  for (const std::vector<int>& owned : shuffled_thirds(60)) {
    const Selection s = touching(whole.elements(), whole.node_count(), owned);
    const auto found = all(*whole.part(s), taken(X, s.nodes), taken(v, s.nodes));
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t i = 0; i < owned.size(); ++i)
        EXPECT_EQ(found[q][i], expected[q][static_cast<std::size_t>(owned[i])])
            << "quantity " << q << ", node " << owned[i];
  }
}

TEST(FibreModel, OwnedNodesComeFirstInTheOrderGiven)
{
  const FibreModel whole(random_network(10, 23));
  const std::vector<int> owned{7, 2, 5};
  const Selection s = touching(whole.elements(), whole.node_count(), owned);
  ASSERT_GT(s.nodes.size(), owned.size());
  EXPECT_TRUE(std::equal(owned.begin(), owned.end(), s.nodes.begin()));
  EXPECT_EQ(whole.part(s)->start(), taken(whole.start(), s.nodes));
  std::vector<int> numbers = s.nodes;
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end()) << "a node appears twice";
}

TEST(FibreModel, LeavesOutWhatDoesNotTouchTheOwnedNodes)
{
  FibreNetwork chain;
  for (int n = 0; n < 10; ++n) chain.X.push_back({static_cast<double>(n), 0.0, 0.0});
  for (int n = 0; n < 9; ++n) chain.springs.add(n, n + 1, 1.0, 0.5, false);
  const FibreModel whole(chain);
  const std::vector<int> owned{4};
  const Selection s = touching(whole.elements(), whole.node_count(), owned);
  EXPECT_EQ(s.nodes, (std::vector<int>{4, 3, 5}));
  EXPECT_EQ(s.elements, (std::vector<int>{3, 4}));
  EXPECT_EQ(whole.part(s)->elements().nodes, (std::vector<int>{1, 0, 0, 2}));
}

}  // namespace
}  // namespace valsalva::ib3d
