// Nodes on several ranks: wherever they are and however often they move house, the positions gathered and the
// forces summed are those of the whole network on one rank.
#include "ib3d/interaction/node_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "furthest_apart.hpp"
#include "ib3d/fluid/tube.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"
#include "ib3d/output/mpi_session.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "ib3d/structure/random_network.hpp"

namespace valsalva::ib3d {
namespace {

constexpr int kNodes = 200;
const Vec3 kSize{2, 2, 4};

/// Positions inside the box, another set for every round.
std::vector<Vec3> positions(int round)
{
  std::vector<Vec3> X = random_vectors(kNodes, 31 + static_cast<unsigned>(round));
  for (Vec3& x : X) x = {1 + 0.999 * x[0], 1 + 0.999 * x[1], 2 + 1.999 * x[2]};
  return X;
}

std::unique_ptr<const ElasticModel> model()
{
  FibreNetwork n = random_network(kNodes, 5);
  n.X = positions(0);
  return std::make_unique<FibreModel>(std::move(n));
}

std::vector<Vec3> local_values(const NodeDistribution& nodes, const std::vector<Vec3>& global)
{
  std::vector<Vec3> local;
  for (int n : nodes.global()) local.push_back(global[static_cast<std::size_t>(n)]);
  return local;
}

int owned_by_all(const NodeDistribution& nodes)
{
  int sum = nodes.owned();
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return sum;
}

TEST(NodeDistribution, MovingAcrossBoxesKeepsPositionsAndForces)
{
  for (const int boxes : {0, 8}) {
    const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD, boxes);
    const Level& level = grid.finest();
    NodeDistribution nodes(model(), level);
    std::vector<Vec3> X = nodes.X();
    for (int round = 0; round < 4; ++round) {
      const std::vector<Vec3> wanted = positions(round);
      std::vector<Vec3> moved = local_values(nodes, wanted);
      const double out = Communicator(MPI_COMM_WORLD).max(nodes.farthest_out(moved));
      EXPECT_EQ(out > kNodeDrift, round > 0 && level.patches.size() > 1);
      for (std::size_t n = static_cast<std::size_t>(nodes.owned()); n < moved.size(); ++n)
        moved[n] = {1e9, 1e9, 1e9};  // only the owner's word counts
      nodes.redistribute(moved);
      X = nodes.X();
      EXPECT_EQ(owned_by_all(nodes), kNodes);
      EXPECT_LE(nodes.farthest_out(X), 0);
      EXPECT_EQ(furthest_apart(nodes.gather(X), wanted), 0);
      EXPECT_EQ(furthest_apart(X, local_values(nodes, wanted)), 0);

      std::vector<Vec3> F(X.size()), F_whole(kNodes);
      nodes.part().add_force(X, F);
      nodes.whole().add_force(wanted, F_whole);
      EXPECT_LT(furthest_apart(nodes.gather(F), F_whole), 1e-11);
    }
  }
}

TEST(NodeDistribution, NodesLieInThePatchTheyAreCountedIn)
{
  const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD, 8);
  const Level& level = grid.finest();
  const NodeDistribution nodes(model(), level);
  for (int p = 0; p < level.local_count(); ++p)
    for (int n = nodes.first()[static_cast<std::size_t>(p)];
         n < nodes.first()[static_cast<std::size_t>(p) + 1]; ++n) {
      Int3 cell{};
      for (int d = 0; d < 3; ++d)
        cell[static_cast<std::size_t>(d)] =
            static_cast<int>(std::floor(nodes.X()[static_cast<std::size_t>(n)][d] / level.h));
      EXPECT_TRUE(level.local_box(p).contains(cell));
    }
  EXPECT_EQ(nodes.first().back(), nodes.owned());
}

TEST(NodeDistribution, ANodeOutsideItsPatchIsFoundAsFarOutAsItLies)
{
  const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD);
  const Level& level = grid.finest();
  const NodeDistribution nodes(model(), level);
  if (nodes.owned() == 0) return;
  const IndexBox& box = level.local_box(0);
  for (int d = 0; d < 3; ++d)
    for (const double out : {0.75, 2.5}) {
      std::vector<Vec3> X = nodes.X();
      X[0][d] = (box.lo[static_cast<std::size_t>(d)] - out) * level.h;
      EXPECT_NEAR(nodes.farthest_out(X), out, 1e-12);
      X[0][d] = (box.hi[static_cast<std::size_t>(d)] + out) * level.h;
      EXPECT_NEAR(nodes.farthest_out(X), out, 1e-12);
    }
}

TEST(NodeDistribution, CopiesHoldTheValuesOfTheOwners)
{
  const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD);
  const NodeDistribution nodes(model(), grid.finest());
  const std::vector<Vec3> wanted = random_vectors(kNodes, 99);
  std::vector<Vec3> values = local_values(nodes, wanted);
  std::fill(values.begin() + nodes.owned(), values.end(), Vec3{0, 0, 0});
  nodes.fill_copies(values);
  EXPECT_EQ(furthest_apart(values, local_values(nodes, wanted)), 0);
  const std::vector<int> few{17, 3, 190};
  const std::vector<Vec3> found = nodes.gather(values, few);
  for (std::size_t m = 0; m < few.size(); ++m)
    EXPECT_EQ(norm(found[m] - wanted[static_cast<std::size_t>(few[m])]), 0);
}

TEST(NodeDistribution, LostNodesAndNumbersThatAreNoneAreErrorsOnAllRanks)
{
  const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD);
  for (const double bad : {7.0, std::nan("")}) {
    NodeDistribution nodes(model(), grid.finest());
    std::vector<Vec3> X = nodes.X();
    for (int n = 0; n < nodes.owned(); ++n)
      if (nodes.global()[static_cast<std::size_t>(n)] == 11) {
        X[static_cast<std::size_t>(n)][2] = bad;
        EXPECT_GT(nodes.farthest_out(X), kNodeDrift);
      }
    EXPECT_THROW(nodes.redistribute(X), SolverError);
  }
}

TEST(NodeDistribution, ACheckpointBringsBackTheOrderOfTheNodesAndWhatTheyCarry)
{
  const std::string path = shared_file("nodes.h5");
  for (const int boxes : {0, 8}) {
    const Hierarchy grid(walled_box(kSize), 0.125, MPI_COMM_WORLD, boxes);
    NodeDistribution before(model(), grid.finest()), after(model(), grid.finest());
    before.redistribute(local_values(before, positions(1)));
    std::vector<Vec3> restored;
    // Later positions: in their own order of cells the nodes would be sorted otherwise.
    std::vector<Vec3> drifted = positions(1), elsewhere = random_vectors(kNodes, 77);
    for (std::size_t n = 0; n < drifted.size(); ++n) drifted[n] += 0.1 * elsewhere[n];
    std::vector<Vec3> X = local_values(before, drifted);
    {
      Checkpoint c = Checkpoint::create(path, MPI_COMM_WORLD);
      before.save_or_restore(c);
      before.save_or_restore(c, "X", X);
      c.close();
    }
    Checkpoint c = Checkpoint::open(path, MPI_COMM_WORLD);
    after.save_or_restore(c);
    after.save_or_restore(c, "X", restored);
    EXPECT_EQ(after.global(), before.global());
    EXPECT_EQ(after.owned(), before.owned());
    EXPECT_EQ(after.first(), before.first());
    EXPECT_TRUE(restored == X);
  }
}

}  // namespace
}  // namespace valsalva::ib3d
