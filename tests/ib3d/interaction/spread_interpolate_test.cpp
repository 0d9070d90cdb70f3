// The exchange identities of the immersed boundary method, to rounding, inside and at the sides of the
// domain.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ib3d/fluid/tube.hpp"
#include "ib3d/interaction/delta.hpp"
#include "ib3d/interaction/node_distribution.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"

namespace valsalva::ib3d {
namespace {

/// Random nodes with random forces, between `margin` and size - margin.
struct Cloud {
  std::vector<Vec3> X, F;
  Cloud(int count, const Vec3& size, double margin)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1), force(-1, 1);
    for (int n = 0; n < count; ++n) {
      X.push_back({margin + (size[0] - 2 * margin) * unit(random),
                   margin + (size[1] - 2 * margin) * unit(random),
                   margin + (size[2] - 2 * margin) * unit(random)});
      F.push_back({force(random), force(random), force(random)});
    }
  }
};

/// The nodes of one rank, their forces, and everything needed to exchange with the grid.
struct Exchange {
  Exchange(const Level& level, const Cloud& cloud)
      : owner(std::make_unique<FibreModel>(FibreNetwork{cloud.X, {}, {}, {}, {}, {}}), level),
        interaction(level),
        X(owner.X()),
        f(level)
  {
    for (int n : owner.global()) F.push_back(cloud.F[static_cast<std::size_t>(n)]);
    interaction.spread(owner.first(), X, F, f);
  }
  NodeDistribution owner;
  Interaction interaction;
  std::vector<Vec3> X, F;
  MacField f;
};

double sum(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

/// Sum over all owned faces of g(position, component, f).
template <class G>
double sum_over_faces(const Level& level, const MacField& f, G&& g)
{
  double total = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(level, p, c, [&](int i, int j, int k) {
        Vec3 x{(i + 0.5) * level.h, (j + 0.5) * level.h, (k + 0.5) * level.h};
        x[c] -= 0.5 * level.h;
        total += g(x, c, f(p, c)(i, j, k)) * std::pow(level.h, 3);
      });
  return sum(total);
}

/// A smooth velocity that vanishes in normal direction on the walls (no condition on the z sides).
void fill_velocity(const Level& level, MacField& u)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(level, p, c, [&](int i, int j, int k) {
        const Int3 at{i, j, k};
        const bool wall =
            c < 2 && (at[static_cast<std::size_t>(c)] == level.box.lo[static_cast<std::size_t>(c)] ||
                      at[static_cast<std::size_t>(c)] == level.box.hi[static_cast<std::size_t>(c)]);
        u(p, c)(i, j, k) =
            wall && !level.domain.periodic(c) ? 0.0 : std::sin(0.7 * i + c) * std::cos(0.9 * j - 0.4 * k);
      });
}

TEST(DeltaFunction, MomentsAndEvenOddSumsAreExactAnywhere)
{
  for (int n = 0; n < 100; ++n) {
    const double r = n / 100.0;
    double w[kDeltaWidth];
    delta_weights(r, w);
    EXPECT_NEAR(w[0] + w[2], 0.5, 1e-15);
    EXPECT_NEAR(w[1] + w[3], 0.5, 1e-15);
    EXPECT_NEAR(-w[0] + w[2] + 2 * w[3], r, 1e-15);
    EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3], 3.0 / 8.0, 1e-15);
  }
}

TEST(SpreadInterpolate, ForceAndTorqueAreConserved)
{
  const Vec3 size{2, 2, 4};
  const Hierarchy grid(walled_box(size), 2.0 / 16, MPI_COMM_WORLD, 4);
  const Level& level = grid.finest();
  const Cloud cloud(400, size, 2.01 * level.h);
  const Exchange x(level, cloud);
  for (int c = 0; c < 3; ++c) {
    double force = 0, torque = 0;
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    for (std::size_t n = 0; n < cloud.X.size(); ++n) {
      force += cloud.F[n][c];
      torque += cross(cloud.X[n], cloud.F[n])[c];
    }
    EXPECT_NEAR(sum_over_faces(level, x.f, [&](const Vec3&, int d, double f) { return d == c ? f : 0; }),
                force, 1e-12);
    EXPECT_NEAR(sum_over_faces(level, x.f,
                               [&](const Vec3& at, int d, double f) {
                                 return d == b ? at[a] * f : d == a ? -at[b] * f : 0.0;
                               }),
                torque, 1e-11);
  }
}

void expect_adjoint(const Domain& domain, int boxes, double margin)
{
  const Hierarchy grid(domain, domain.size[0] / 16, MPI_COMM_WORLD, boxes);
  const Level& level = grid.finest();
  const Cloud cloud(600, domain.size, margin);
  Exchange x(level, cloud);
  MacField u(level);
  fill_velocity(level, u);
  x.interaction.fill_ghosts(u);
  std::vector<Vec3> U(x.X.size());
  x.interaction.interpolate(x.owner.first(), x.X, u, U);
  double lagrangian = 0;
  for (int n = 0; n < x.owner.owned(); ++n)
    lagrangian += dot(U[static_cast<std::size_t>(n)], x.F[static_cast<std::size_t>(n)]);
  lagrangian = sum(lagrangian);
  double eulerian = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(level, p, c,
                          [&](int i, int j, int k) { eulerian += u(p, c)(i, j, k) * x.f(p, c)(i, j, k); });
  eulerian = sum(eulerian) * std::pow(level.h, 3);
  EXPECT_GT(std::abs(lagrangian), 0.1);
  EXPECT_NEAR(eulerian / lagrangian, 1.0, 1e-12);
}

TEST(SpreadInterpolate, PowerIsConservedInside)
{
  expect_adjoint(walled_box({2, 2, 4}), 1, 0.3);
}
TEST(SpreadInterpolate, PowerIsConservedUpToTheSides)
{
  expect_adjoint(walled_box({2, 2, 4}), 1, 0.0);
}
TEST(SpreadInterpolate, PowerIsConservedAcrossBoxes)
{
  expect_adjoint(walled_box({2, 2, 4}), 8, 0.0);
}
TEST(SpreadInterpolate, PowerIsConservedThroughPeriodicSides)
{
  expect_adjoint(periodic_box({2, 2, 4}), 2, 0.0);
}

TEST(SpreadInterpolate, LinearVelocityIsInterpolatedExactly)
{
  const Vec3 size{2, 2, 4};
  const Hierarchy grid(walled_box(size), 2.0 / 16, MPI_COMM_WORLD, 2);
  const Level& level = grid.finest();
  const Cloud cloud(200, size, 2.01 * level.h);
  Exchange x(level, cloud);
  MacField u(level);
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_index(u(p, c).stored(), [&](int i, int j, int k) {
        u(p, c)(i, j, k) =
            1 + 2 * (i + (c == 0 ? 0 : 0.5)) - 3 * (j + (c == 1 ? 0 : 0.5)) + (k + (c == 2 ? 0 : 0.5));
      });
  std::vector<Vec3> U(x.X.size());
  x.interaction.interpolate(x.owner.first(), x.X, u, U);
  for (int n = 0; n < x.owner.owned(); ++n) {
    const Vec3& X = x.X[static_cast<std::size_t>(n)];
    const double exact = 1 + (2 * X[0] - 3 * X[1] + X[2]) / level.h;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(U[static_cast<std::size_t>(n)][c], exact, 1e-11);
  }
}

}  // namespace
}  // namespace valsalva::ib3d
