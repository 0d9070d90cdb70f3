#include "ib3d/structure/fibres/fibre_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "ib3d/structure/fibres/fibre_force.hpp"
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

TEST(RestrictTo, PartsReproduceTheForcesOfTheWholeToTheLastBit)
{
  const FibreNetwork whole = random_network(60, 21);
  const std::vector<Vec3> X = random_vectors(60, 22);
  std::vector<Vec3> F(X.size());
  fibre_force(whole, X, F);
  for (const std::vector<int>& owned : shuffled_thirds(60)) {
    const FibrePart part = restrict_to(whole, owned);
    std::vector<Vec3> X_part, F_part(part.global.size());
    for (int node : part.global) X_part.push_back(X[static_cast<std::size_t>(node)]);
    fibre_force(part.network, X_part, F_part);
    for (std::size_t i = 0; i < owned.size(); ++i)
      EXPECT_EQ(F_part[i], F[static_cast<std::size_t>(owned[i])]) << "global node " << owned[i];
  }
}

TEST(RestrictTo, OwnedNodesComeFirstInTheOrderGiven)
{
  const FibreNetwork whole = random_network(10, 23);
  const std::vector<int> owned{7, 2, 5};
  const FibrePart part = restrict_to(whole, owned);
  ASSERT_EQ(part.owned, 3);
  EXPECT_TRUE(std::equal(owned.begin(), owned.end(), part.global.begin()));
  for (std::size_t i = 0; i < part.global.size(); ++i)
    EXPECT_EQ(part.network.X[i], whole.X[static_cast<std::size_t>(part.global[i])]);
  std::vector<int> numbers = part.global;
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end()) << "a node appears twice";
}

TEST(RestrictTo, LeavesOutWhatDoesNotTouchTheOwnedNodes)
{
  FibreNetwork chain;
  for (int n = 0; n < 10; ++n) chain.X.push_back({static_cast<double>(n), 0.0, 0.0});
  for (int n = 0; n < 9; ++n) chain.springs.add(n, n + 1, 1.0, 0.5, false);
  const std::vector<int> owned{4};
  const FibrePart part = restrict_to(chain, owned);
  EXPECT_EQ(part.network.springs.count(), 2);
  EXPECT_EQ(part.global, (std::vector<int>{4, 3, 5}));
}

}  // namespace
}  // namespace valsalva::ib3d
