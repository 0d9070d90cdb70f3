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

constexpr double kPi = std::numbers::pi, kRho = 1.06;

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

ExactFlow closed_box(bool advection, double nu = 0.01)
{
  ExactFlow flow;
  flow.domain = [](double h) {
    Domain domain = walled_box({1, 1, 8 * h});
    domain.sides[4] = domain.sides[5] = SideKind::periodic;
    return domain;
  };
  flow.fluid = {kRho, kRho * nu};
  flow.velocity = [](int c, const Vec3& x, double t) {
    const Shape s(x);
    return c == 2 ? 0.0 : rate(t) * (c == 0 ? s.u : s.v);
  };
  flow.pressure = [](const Vec3& x, double t) { return kRho * std::sin(kPi * x[0]) * x[1] * rate(t); };
  flow.force = [advection, nu](int c, const Vec3& x, double t) {
    const Shape s(x);
    const double g = rate(t), dg = -2 * std::sin(2 * t), convected = advection ? g * g : 0.0;
    if (c == 0)
      return kRho * (dg * s.u + convected * (s.u * s.ux + s.v * s.uy) - nu * g * s.lap_u +
                     kPi * std::cos(kPi * x[0]) * x[1] * g);
    if (c == 1)
      return kRho *
             (dg * s.v + convected * (s.u * s.vx + s.v * s.vy) - nu * g * s.lap_v + std::sin(kPi * x[0]) * g);
    return 0.0;
  };
  return flow;
}

TEST(FluidOrder, NoSlipWallsAreSecondOrder)
{
  for (const Scheme& scheme : kSchemes) expect_second_order(closed_box(true), scheme, 32);
}

TEST(FluidOrder, StokesFlowBetweenNoSlipWallsIsSecondOrder)
{
  for (const Scheme& scheme : kStokesSchemes) expect_second_order(closed_box(false), scheme, 16, 1.9);
}

TEST(FluidOrder, CrankNicolsonIsSecondOrderBeyondTheExplicitStepLimit)
{
  // nu dt/h^2 = 0.32 and 0.64 where explicit viscosity allows 1/12.
  expect_second_order(closed_box(true, 0.2), kSchemes[2], 16);
  expect_second_order(closed_box(false, 0.2), kStokesSchemes[1], 16);
}

}  // namespace
}  // namespace valsalva::ib3d
