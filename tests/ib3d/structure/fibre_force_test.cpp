#include "ib3d/structure/fibres/fibre_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/structure/fibres/fibre_strain.hpp"
#include "random_network.hpp"
#include "resultant.hpp"

namespace valsalva::ib3d {
namespace {

double largest(const std::vector<Vec3>& v)
{
  return max_or_nan(v, common::norm);
}

TEST(FibreForce, IsTheNegativeGradientOfTheEnergy)
{
  const FibreNetwork network = random_network(12, 3);
  std::vector<Vec3> X = network.X, F(X.size());
  add_fibre_force(network, X, F);
  const double step = 1e-5, scale = largest(F);
  for (std::size_t i = 0; i < X.size(); ++i) {
    for (int d = 0; d < 3; ++d) {
      const double x = X[i][d];
      X[i][d] = x + step;
      const double above = fibre_energy(network, X);
      X[i][d] = x - step;
      const double below = fibre_energy(network, X);
      X[i][d] = x;
      EXPECT_NEAR(F[i][d], -(above - below) / (2.0 * step), 1e-6 * scale)
          << "node " << i << " direction " << d;
    }
  }
}

TEST(FibreForce, IsAddedToWhatIsThere)
{
  const FibreNetwork network = random_network(6, 5);
  const Vec3 other{1.0, 2.0, 3.0};
  std::vector<Vec3> alone(network.X.size(), Vec3{0.0, 0.0, 0.0}), added(network.X.size(), other);
  add_fibre_force(network, network.X, alone);
  add_fibre_force(network, network.X, added);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_LT(norm(added[i] - alone[i] - other), 1e-13);
}

TEST(FibreForce, TangentMatchesFiniteDifferencesOfTheForce)
{
  const FibreNetwork network = random_network(12, 7);
  const std::vector<Vec3> v = random_vectors(12, 99);
  std::vector<Vec3> Kv(v.size()), ahead = network.X, behind = network.X, Fa(v.size()), Fb(v.size());
  add_fibre_stiffness_times(network, network.X, v, Kv);
  const double step = 1e-5;
  for (std::size_t i = 0; i < v.size(); ++i) {
    ahead[i] += step * v[i];
    behind[i] -= step * v[i];
  }
  add_fibre_force(network, ahead, Fa);
  add_fibre_force(network, behind, Fb);
  for (std::size_t i = 0; i < v.size(); ++i)
    EXPECT_LT(norm(Kv[i] + (0.5 / step) * (Fa[i] - Fb[i])), 1e-6 * largest(Kv)) << "node " << i;
}

TEST(FibreForce, TangentIsSymmetric)
{
  const FibreNetwork network = random_network(12, 11);
  const std::vector<Vec3> u = random_vectors(12, 1), v = random_vectors(12, 2);
  std::vector<Vec3> Ku(u.size()), Kv(v.size());
  add_fibre_stiffness_times(network, network.X, u, Ku);
  add_fibre_stiffness_times(network, network.X, v, Kv);
  double uKv = 0.0, vKu = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    uKv += dot(u[i], Kv[i]);
    vKu += dot(v[i], Ku[i]);
  }
  EXPECT_NEAR(uKv, vKu, 1e-12 * std::abs(uKv));
}

TEST(FibreForce, SpringsAndBeamsExertNoTotalForceOrTorque)
{
  FibreNetwork network = random_network(40, 13);
  network.tethers = Tethers{};
  std::vector<Vec3> F(network.X.size());
  add_fibre_force(network, network.X, F);
  expect_no_resultant(network.X, F);
}

FibreNetwork single_spring(bool tension_only)
{
  FibreNetwork network;
  network.X = {{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  network.springs.a = {0};
  network.springs.b = {1};
  network.springs.stiffness = {10.0};
  network.springs.rest_length = {1.0};
  network.springs.tension_only = {static_cast<std::uint8_t>(tension_only ? 1 : 0)};
  network.groups = {NodeGroup{"all", 0, 2}};
  return network;
}

TEST(FibreForce, TensionOnlySpringDoesNotPush)
{
  const FibreNetwork network = single_spring(true);
  std::vector<Vec3> F(2), Kv(2), v = random_vectors(2, 4);
  add_fibre_force(network, network.X, F);
  add_fibre_stiffness_times(network, network.X, v, Kv);
  EXPECT_EQ(norm(F[0]), 0.0);
  EXPECT_EQ(norm(Kv[0]), 0.0);
  EXPECT_EQ(fibre_energy(network, network.X), 0.0);
}

TEST(FibreForce, TwoSidedSpringPushesWithStiffnessTimesStrain)
{
  const FibreNetwork network = single_spring(false);
  std::vector<Vec3> F(2);
  add_fibre_force(network, network.X, F);
  EXPECT_DOUBLE_EQ(F[1][0], 5.0);
  EXPECT_DOUBLE_EQ(F[0][0], -5.0);
}

/// A fibre through the points at(t) for uneven t, beams of rigidity 1.
template <class Curve>
FibreNetwork uneven_fibre(Curve at, int nodes, double end)
{
  FibreNetwork network;
  for (int n = 0; n < nodes; ++n) {
    const double t = end * (n + 0.3 * std::sin(2.0 * n)) / (nodes - 1);
    network.X.push_back(at(t));
  }
  for (int n = 1; n + 1 < nodes; ++n) {
    const auto i = static_cast<std::size_t>(n);
    network.beams.add({n - 1, n, n + 1}, 1.0, norm(network.X[i] - network.X[i - 1]),
                      norm(network.X[i + 1] - network.X[i]));
  }
  return network;
}

TEST(FibreForce, StraightUnevenBeamHasNoEnergyAndNoForce)
{
  const FibreNetwork network = uneven_fibre([](double t) { return Vec3{t, 2.0 * t, -t}; }, 20, 1.0);
  std::vector<Vec3> F(network.X.size());
  add_fibre_force(network, network.X, F);
  EXPECT_LT(fibre_energy(network, network.X), 1e-24);
  EXPECT_LT(largest(F), 1e-9);
}

TEST(FibreForce, BeamOnAnUnevenArcHasHalfRigidityCurvatureSquaredTimesLength)
{
  const double R = 2.0, end = 1.5;
  const FibreNetwork network = uneven_fibre(
      [&](double a) {
        return Vec3{R * std::cos(a), R * std::sin(a), 0.0};
      },
      400, end);
  EXPECT_NEAR(fibre_energy(network, network.X), 0.5 * end * R / (R * R), 0.01 * 0.5 * end / R);
}

TEST(FibreStrain, CountsSlackTensionOnlySpringsAsZero)
{
  FibreNetwork network = single_spring(true);
  EXPECT_EQ(fibre_strain(network, network.X, network.groups[0]).largest, 0.0);
  network.X[1][0] = 1.25;
  EXPECT_DOUBLE_EQ(fibre_strain(network, network.X, network.groups[0], SpringFamily::tension_only).mean,
                   0.25);
  EXPECT_EQ(fibre_strain(network, network.X, network.groups[0], SpringFamily::two_sided).mean, 0.0);
  EXPECT_DOUBLE_EQ(fibre_strain(single_spring(false), single_spring(false).X, network.groups[0]).largest,
                   -0.5);
}

TEST(FibreStrain, FindsTheLargestTetherDisplacementOfAGroup)
{
  FibreNetwork network;
  network.X = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  network.tethers.node = {0, 1};
  network.tethers.stiffness = {1.0, 1.0};
  network.tethers.target = {{0.0, 3.0, 4.0}, {1.0, 0.5, 0.0}};
  EXPECT_DOUBLE_EQ(largest_tether_displacement(network, network.X), 5.0);
}

TEST(FibreStrain, IsNanWhereAPositionIs)
{
  FibreNetwork network = random_network(20, 3);
  std::vector<Vec3> X = network.X;
  const NodeGroup everything{"all", 0, network.node_count()};
  ASSERT_TRUE(std::isfinite(fibre_strain(network, X, everything).largest));
  ASSERT_TRUE(std::isfinite(largest_tether_displacement(network, X)));
  X[static_cast<std::size_t>(network.springs.a[7])][1] = std::nan("");
  EXPECT_TRUE(std::isnan(fibre_strain(network, X, everything).largest));
  X = network.X;
  X[static_cast<std::size_t>(network.tethers.node.front())][2] = std::nan("");
  EXPECT_TRUE(std::isnan(largest_tether_displacement(network, X)));
}

}  // namespace
}  // namespace valsalva::ib3d
