#include "ib3d/structure/aortic_root/leaflet_equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.hpp"
#include "common/units.hpp"
#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "ib3d/structure/fibres/fibre_force.hpp"

namespace valsalva::ib3d {
namespace {

const RootDimensions kRoot;
const LeafletMaterial kMaterial;

struct ClosedLeaflet {
  LeafletLattice lattice;
  LeafletEquilibrium at_85_mmHg;
};

ClosedLeaflet close_leaflet(double h)
{
  LeafletLattice lattice = leaflet_lattice(kRoot, kMaterial, h);
  LeafletEquilibrium found =
      find_leaflet_equilibrium(lattice, kMaterial, 85.0, closed_leaflet_guess(kRoot, lattice));
  return {std::move(lattice), std::move(found)};
}

const ClosedLeaflet& closed_leaflet()
{
  static const ClosedLeaflet closed = close_leaflet(10.0 / 64);
  return closed;
}

TEST(LeafletLattice, TrianglesCoverTheSurfaceBetweenAttachmentAndFreeEdgeOnce)
{
  const LeafletLattice lattice = leaflet_lattice(kRoot, kMaterial, 10.0 / 64);
  double area = 0.0;
  for (const auto& t : lattice.triangles) {
    const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]),
               c = static_cast<std::size_t>(t[2]);
    const double twice = (lattice.s[b] - lattice.s[a]) * (lattice.z[c] - lattice.z[a]) -
                         (lattice.z[b] - lattice.z[a]) * (lattice.s[c] - lattice.s[a]);
    ASSERT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  const double half_ellipse = 0.5 * std::numbers::pi * leaflet_half_width(kRoot) * kRoot.commissure_height;
  EXPECT_NEAR(area, half_ellipse, 0.005 * half_ellipse);
}

TEST(LeafletLattice, SpringsAreNeitherTooShortNorTooLong)
{
  const double h = 10.0 / 64;
  const LeafletLattice lattice = leaflet_lattice(kRoot, kMaterial, h);
  const Springs& springs = lattice.network.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    const double l0 = springs.rest_length[n];
    EXPECT_GT(l0, 0.4 * std::min(lattice.row_distance, lattice.column_distance));
    const bool ends_on_edge = lattice.on_edge[static_cast<std::size_t>(springs.a[n])] != 0 ||
                              lattice.on_edge[static_cast<std::size_t>(springs.b[n])] != 0;
    EXPECT_LE(l0, ends_on_edge ? 1.5 * h : 0.5 * h * (1.0 + 1e-12));
  }
}

TEST(LeafletEquilibrium, InnerNodesAreInBalance)
{
  const auto& [lattice, found] = closed_leaflet();
  const double pressure = common::dyn_cm2_from_mmHg(85.0);
  std::vector<Vec3> load(found.X.size()), elastic(found.X.size());
  leaflet_load(lattice, pressure, found.X, load);
  add_fibre_force(lattice.network, found.X, elastic);
  const double node_load = pressure * lattice.row_distance * lattice.column_distance;
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (lattice.on_edge[i] == 0) {
      EXPECT_LT(norm(load[i] + elastic[i]), 1e-3 * node_load) << "node " << i;
    }
  }
}

TEST(LeafletEquilibrium, AttachmentBearsThePressureOnAThirdOfTheTube)
{
  const auto& [lattice, found] = closed_leaflet();
  const double pressure = common::dyn_cm2_from_mmHg(85.0);
  std::vector<Vec3> load(found.X.size()), elastic(found.X.size());
  leaflet_load(lattice, pressure, found.X, load);
  add_fibre_force(lattice.network, found.X, elastic);
  Vec3 total_load{0.0, 0.0, 0.0}, reaction{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < load.size(); ++i) {
    total_load += load[i];
    if (lattice.on_edge[i] != 0) reaction -= load[i] + elastic[i];
  }
  EXPECT_LT(norm(total_load + reaction), 1e-4 * norm(reaction));
  const double third = pressure * std::numbers::pi * kRoot.annulus_radius * kRoot.annulus_radius / 3.0;
  EXPECT_NEAR(reaction[2], third, 0.06 * third) << "the gaps to the neighbours take a few percent";
}

TEST(LeafletEquilibrium, ClosedLeafletCoaptsWithinTheStatedStrains)
{
  const LeafletShape& shape = closed_leaflet().at_85_mmHg.shape;
  EXPECT_LE(shape.residual, kEquilibriumResidual);
  EXPECT_GT(shape.coaptation_height_cm, 0.25 * kRoot.annulus_radius);
  EXPECT_LT(shape.coaptation_height_cm, 0.5 * kRoot.annulus_radius);
  EXPECT_GT(shape.circumferential_strain_mean, 0.04);
  EXPECT_LT(shape.circumferential_strain_mean, 0.08);
  EXPECT_LT(shape.circumferential_strain_max, 0.14);
  EXPECT_LT(shape.radial_strain_max, 0.12);
  EXPECT_DOUBLE_EQ(shape.tension_max, kMaterial.circumferential_stiffness * shape.circumferential_strain_max);
}

TEST(LeafletEquilibrium, IsMirrorSymmetric)
{
  const auto& [lattice, found] = closed_leaflet();
  const std::vector<int>& edge = lattice.network.free_edges.front();
  for (std::size_t k = 0; k < edge.size(); ++k) {
    const Vec3 left = found.X[static_cast<std::size_t>(edge[k])];
    const Vec3 right = found.X[static_cast<std::size_t>(edge[edge.size() - 1 - k])];
    EXPECT_LT(norm(left - Vec3{right[0], -right[1], right[2]}), 1e-6);
  }
}

TEST(LeafletEquilibrium, SurfaceIsSmoothButForTheFoldAtTheAxis)
{
  const auto& [lattice, found] = closed_leaflet();
  const Beams& beams = lattice.network.beams;
  const double fold = 60.0, smooth = 30.0;  // degrees; the two contact planes meet at the fold's angle
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const auto i = static_cast<std::size_t>(beams.x1[n]);
    const Vec3 before = found.X[i] - found.X[static_cast<std::size_t>(beams.x0[n])];
    const Vec3 after = found.X[static_cast<std::size_t>(beams.x2[n])] - found.X[i];
    const double turn =
        std::acos(dot(before, after) / (norm(before) * norm(after))) * 180.0 / std::numbers::pi;
    const bool in_fold = std::abs(lattice.s[i]) < lattice.column_distance;
    EXPECT_LT(turn, in_fold ? fold : smooth) << "at s = " << lattice.s[i] << ", z = " << lattice.z[i];
  }
}

TEST(LeafletEquilibrium, KeepsAGapToTheNeighbours)
{
  const auto& [lattice, found] = closed_leaflet();
  const LeafletEquilibrium start = find_leaflet_equilibrium(lattice, kMaterial, 3.0, found.X);
  for (const LeafletEquilibrium* shape : {&found, &start}) {
    for (std::size_t i = 0; i < shape->X.size(); ++i) {
      if (lattice.on_edge[i] != 0) continue;
      const Vec3 x = shape->X[i];
      EXPECT_LT(std::abs(x[1]), std::sqrt(3.0) * x[0])
          << "node " << i << " is beyond the plane of its neighbour";
    }
  }
  EXPECT_LT(start.shape.circumferential_strain_mean, 0.1 * found.shape.circumferential_strain_mean);
}

TEST(LeafletEquilibrium, HardlyDependsOnTheGrid)
{
  const LeafletShape coarse = closed_leaflet().at_85_mmHg.shape,
                     fine = close_leaflet(10.0 / 96).at_85_mmHg.shape;
  EXPECT_NEAR(coarse.coaptation_height_cm, fine.coaptation_height_cm, 0.03 * fine.coaptation_height_cm);
  EXPECT_NEAR(coarse.circumferential_strain_mean, fine.circumferential_strain_mean,
              0.03 * fine.circumferential_strain_mean);
}

TEST(LeafletEquilibrium, IsTheSameEveryTime)
{
  EXPECT_EQ(close_leaflet(10.0 / 64).at_85_mmHg.X, closed_leaflet().at_85_mmHg.X);
}

TEST(LeafletEquilibrium, SaysSoWhenThereIsNone)
{
  const LeafletLattice& lattice = closed_leaflet().lattice;
  std::vector<Vec3> guess = lattice.network.X;
  guess[static_cast<std::size_t>(lattice.middle.front())][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_leaflet_equilibrium(lattice, kMaterial, 85.0, guess), SolverError);
}

}  // namespace
}  // namespace valsalva::ib3d
