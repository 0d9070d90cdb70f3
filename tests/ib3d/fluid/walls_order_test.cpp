// Flow in a closed box with no slip, made exact by a body force: from psi = sin^2(pi x) sin^2(pi y) g(t)/pi
//     u = sin^2(pi x) sin(2 pi y) g,   v = -sin(2 pi x) sin^2(pi y) g,   p = rho sin(pi x) y g,
//     f = rho (u_t + u.grad u - nu lap u) + grad p,   g = cos 2t.
// The pressure's gradient does not vanish on the walls: a projection that imposes dp/dn = 0 on the physical
// pressure would lose its order here.
#include <gtest/gtest.h>

#include <numbers>

#include "ib3d/fluid/order.hpp"
#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kPi = std::numbers::pi, kRho = 1.06, kNu = 0.01;

double rate(double t)
{
  return std::cos(2 * t);
}

/// The velocity with its derivatives, for g = 1.
struct Shape {
  double u, v, ux, uy, vx, vy, lap_u, lap_v;
  explicit Shape(const Vec3& x)
  {
    const double s2 = std::pow(std::sin(kPi * x[0]), 2), q2 = std::pow(std::sin(kPi * x[1]), 2);
    const double S = std::sin(2 * kPi * x[0]), C = std::cos(2 * kPi * x[0]);
    const double Q = std::sin(2 * kPi * x[1]), D = std::cos(2 * kPi * x[1]);
    u = s2 * Q;
    v = -S * q2;
    ux = kPi * S * Q;
    uy = 2 * kPi * s2 * D;
    vx = -2 * kPi * C * q2;
    vy = -kPi * S * Q;
    lap_u = 2 * kPi * kPi * (C * Q - 2 * s2 * Q);
    lap_v = 2 * kPi * kPi * (2 * S * q2 - S * D);
  }
};

ExactFlow closed_box(bool advection)
{
  ExactFlow flow;
  flow.domain = [](double h) {
    Domain domain = walled_box({1, 1, 8 * h});
    domain.sides[4] = domain.sides[5] = SideKind::periodic;
    return domain;
  };
  flow.fluid = {kRho, kRho * kNu, advection};
  flow.velocity = [](int c, const Vec3& x, double t) {
    const Shape s(x);
    return c == 2 ? 0.0 : rate(t) * (c == 0 ? s.u : s.v);
  };
  flow.pressure = [](const Vec3& x, double t) { return kRho * std::sin(kPi * x[0]) * x[1] * rate(t); };
  flow.force = [advection](int c, const Vec3& x, double t) {
    const Shape s(x);
    const double g = rate(t), dg = -2 * std::sin(2 * t), convected = advection ? g * g : 0.0;
    if (c == 0)
      return kRho * (dg * s.u + convected * (s.u * s.ux + s.v * s.uy) - kNu * g * s.lap_u +
                     kPi * std::cos(kPi * x[0]) * x[1] * g);
    if (c == 1)
      return kRho * (dg * s.v + convected * (s.u * s.vx + s.v * s.vy) - kNu * g * s.lap_v +
                     std::sin(kPi * x[0]) * g);
    return 0.0;
  };
  return flow;
}

TEST(FluidOrder, NoSlipWallsAreSecondOrder)
{
  const Orders order = observed_orders(closed_box(true), 32);
  RecordProperty("velocity_l1", std::to_string(order.velocity.l1));
  RecordProperty("velocity_l2", std::to_string(order.velocity.l2));
  RecordProperty("pressure_l2", std::to_string(order.pressure.l2));
  EXPECT_GT(order.velocity.l1, 1.8);
  EXPECT_GT(order.velocity.l2, 1.8);
  EXPECT_GT(order.pressure.l2, 1.5);
}

TEST(FluidOrder, StokesFlowBetweenNoSlipWallsIsSecondOrder)
{
  const Orders order = observed_orders(closed_box(false), 16);
  RecordProperty("velocity_l2", std::to_string(order.velocity.l2));
  EXPECT_GT(order.velocity.l1, 1.9);
  EXPECT_GT(order.velocity.l2, 1.9);
  EXPECT_GT(order.pressure.l2, 1.5);
}

}  // namespace
}  // namespace valsalva::ib3d
