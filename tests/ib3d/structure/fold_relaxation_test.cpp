#include "ib3d/structure/fibres/fold_relaxation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "random_network.hpp"
#include "resultant.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kSpacing = 0.05, kTime = 5e-4;

void add_beam(FibreNetwork& network, int x0, int x1, int x2, double rigidity)
{
  network.beams.add({x0, x1, x2}, rigidity, kSpacing, kSpacing);
}

/// An even lattice in the plane z = 0, rows first, columns of another rigidity.
FibreNetwork lattice(int columns, int rows)
{
  FibreNetwork network;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) network.X.push_back({i * kSpacing, j * kSpacing, 0.0});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int n = i + columns * j;
      if (i > 0 && i + 1 < columns) add_beam(network, n - 1, n, n + 1, 3.0);
      if (j > 0 && j + 1 < rows) add_beam(network, n - columns, n, n + columns, 7.0);
    }
  return network;
}

std::vector<Vec3> slip(const FibreNetwork& network, const std::vector<Vec3>& X)
{
  std::vector<Vec3> V(X.size(), Vec3{0.0, 0.0, 0.0});
  add_fold_slip(network, X, kTime, V);
  return V;
}

Vec3 turn_of(const Beams& beams, std::size_t n, const std::vector<Vec3>& X)
{
  const Vec3 x0 = X[static_cast<std::size_t>(beams.x0[n])], x1 = X[static_cast<std::size_t>(beams.x1[n])],
             x2 = X[static_cast<std::size_t>(beams.x2[n])];
  return (1.0 / beams.l2[n]) * (x2 - x1) - (1.0 / beams.l1[n]) * (x1 - x0);
}

/// Energy of what turns more than is allowed.
double fold_energy(const Beams& beams, const std::vector<Vec3>& X)
{
  double energy = 0.0;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const double excess = std::max(norm(turn_of(beams, n, X)) - kSharpestTurn, 0.0);
    energy += beams.rigidity[n] * excess * excess / (beams.l1[n] + beams.l2[n]);
  }
  return energy;
}

TEST(FoldRelaxation, WhatTurnsLessThanTheSharpestTurnDoesNotSlip)
{
  FibreNetwork network;
  const double R = 1.02 * kSpacing / kSharpestTurn;
  for (int n = 0; n < 20; ++n)
    network.X.push_back({R * std::cos(n * kSpacing / R), R * std::sin(n * kSpacing / R), 1.0});
  for (int n = 1; n < 19; ++n) add_beam(network, n - 1, n, n + 1, 2.0);
  for (const Vec3& v : slip(network, network.X)) EXPECT_EQ(norm(v), 0.0);
}

TEST(FoldRelaxation, AlternatingLatticeLosesItsExcessInTheTimeGiven)
{
  const int columns = 9, rows = 8;
  const FibreNetwork network = lattice(columns, rows);
  const double a = 0.3 * kSpacing, turn = 4.0 * a / kSpacing;
  std::vector<Vec3> X = network.X;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      X[static_cast<std::size_t>(i + columns * j)][2] = (i + j) % 2 == 0 ? a : -a;
  const std::vector<Vec3> V = slip(network, X);
  for (int j = 2; j < rows - 2; ++j)
    for (int i = 2; i < columns - 2; ++i) {
      const auto n = static_cast<std::size_t>(i + columns * j);
      EXPECT_NEAR(V[n][2], -(1.0 - kSharpestTurn / turn) * X[n][2] / kTime, 1e-10 * a / kTime);
      EXPECT_LT(std::hypot(V[n][0], V[n][1]), 1e-10 * a / kTime);
    }
}

TEST(FoldRelaxation, FoldOfFourNodesDecaysFourTimesAsSlowly)
{
  FibreNetwork network = lattice(16, 1);
  const double a = 0.4 * kSpacing, turn = 2.0 * a / kSpacing;
  for (int n = 0; n < 16; ++n)
    network.X[static_cast<std::size_t>(n)][1] = n % 2 == 1 ? 0.0 : n % 4 == 0 ? a : -a;
  const std::vector<Vec3> V = slip(network, network.X);
  for (std::size_t n = 2; n < 14; ++n)
    EXPECT_NEAR(V[n][1], -0.25 * (1.0 - kSharpestTurn / turn) * network.X[n][1] / kTime, 1e-10 * a / kTime);
}

TEST(FoldRelaxation, StepsAsLongAsTheTimeOnlyEverFlatten)
{
  FibreNetwork network = random_network(40, 17);
  network.tethers = Tethers{};
  std::vector<Vec3> X = network.X;
  const double start = fold_energy(network.beams, X);
  for (int step = 0; step < 3000; ++step) {
    const double before = fold_energy(network.beams, X);
    const std::vector<Vec3> V = slip(network, X);
    for (std::size_t n = 0; n < X.size(); ++n) X[n] += kTime * V[n];
    ASSERT_LE(fold_energy(network.beams, X), before + 1e-14 * start);
  }
  EXPECT_LT(fold_energy(network.beams, X), 1e-3 * start);
}

TEST(FoldRelaxation, FoldedRingSlipsWithoutDriftOrRotation)
{
  FibreNetwork network;
  const int nodes = 24;
  for (int n = 0; n < nodes; ++n) {
    const double r = 0.2 + 0.03 * std::sin(3.7 * n), angle = 2.0 * M_PI * n / nodes;
    network.X.push_back({1.0 + r * std::cos(angle), 2.0 + r * std::sin(angle), 0.04 * std::cos(2.9 * n)});
    add_beam(network, n, (n + 1) % nodes, (n + 2) % nodes, 2.0);
  }
  expect_no_resultant(network.X, slip(network, network.X));
}

TEST(FoldRelaxation, TurnedAndStifferNetworksSlipAlike)
{
  FibreNetwork network = random_network(30, 23);
  const std::vector<Vec3> V = slip(network, network.X);
  const auto turned = [](const Vec3& x) { return Vec3{5.0 - x[1], 6.0 + x[0], 7.0 + x[2]}; };
  std::vector<Vec3> X;
  for (const Vec3& x : network.X) X.push_back(turned(x));
  for (double& rigidity : network.beams.rigidity) rigidity *= 20.0;
  const std::vector<Vec3> W = slip(network, X);
  for (std::size_t n = 0; n < V.size(); ++n)
    EXPECT_LT(norm(W[n] - (turned(V[n]) - turned(Vec3{0.0, 0.0, 0.0}))), 1e-10 * (1.0 + norm(V[n])));
}

TEST(FoldRelaxation, TetheredNodesStay)
{
  const FibreNetwork network = random_network(30, 29);
  const std::vector<Vec3> V = slip(network, network.X);
  EXPECT_GT(max_or_nan(V, common::norm), 1.0);
  for (int node : network.tethers.node) EXPECT_EQ(norm(V[static_cast<std::size_t>(node)]), 0.0);
}

TEST(FoldRelaxation, ARanksPartSlipsAsTheWholeDoes)
{
  const FibreNetwork network = random_network(30, 31);
  const std::vector<Vec3> V = slip(network, network.X);
  const std::vector<int> owned{7, 3, 21, 12, 9};
  const FibreModel whole(network, kTime);
  const auto part = whole.part(touching(whole.elements(), whole.node_count(), owned));
  std::vector<Vec3> W(part->start().size(), Vec3{0.0, 0.0, 0.0});
  part->add_slip(part->start(), 0.0, W);
  for (std::size_t n = 0; n < owned.size(); ++n) EXPECT_EQ(W[n], V[static_cast<std::size_t>(owned[n])]);
}

}  // namespace
}  // namespace valsalva::ib3d
