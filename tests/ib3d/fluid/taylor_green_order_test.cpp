// Decaying Taylor-Green vortices carried by a uniform stream, an exact solution of the Navier-Stokes equations
// without force (Taylor & Green 1937): with a = x - U t, b = y - V t,
//     u = U - cos a sin b e,  v = V + sin a cos b e,  p = -(rho/4)(cos 2a + cos 2b) e^2,  e = exp(-2 nu t).
// The stream makes the advection work; without it the convective term of the vortices is a mere gradient.
#include <gtest/gtest.h>

#include <numbers>

#include "ib3d/fluid/order.hpp"
#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kU = 0.7, kV = -0.4, kNu = 0.02;

ExactFlow taylor_green()
{
  ExactFlow flow;
  flow.length = 2 * std::numbers::pi;
  flow.domain = [](double h) { return periodic_box({2 * std::numbers::pi, 2 * std::numbers::pi, 8 * h}); };
  flow.fluid = {1.06, 1.06 * kNu};
  flow.velocity = [](int c, const Vec3& x, double t) {
    const double a = x[0] - kU * t, b = x[1] - kV * t, e = std::exp(-2 * kNu * t);
    if (c == 0) return kU - std::cos(a) * std::sin(b) * e;
    if (c == 1) return kV + std::sin(a) * std::cos(b) * e;
    return 0.0;
  };
  flow.pressure = [](const Vec3& x, double t) {
    const double a = x[0] - kU * t, b = x[1] - kV * t, e = std::exp(-2 * kNu * t);
    return -0.25 * 1.06 * (std::cos(2 * a) + std::cos(2 * b)) * e * e;
  };
  flow.force = [](int, const Vec3&, double) { return 0.0; };
  flow.end_s = 0.5;
  flow.dt_per_h = 0.07;
  return flow;
}

TEST(FluidOrder, CarriedTaylorGreenVorticesAreSecondOrder)
{
  for (const Scheme& scheme : kSchemes)
    for (const int n : {16, 32}) expect_second_order(taylor_green(), scheme, n);
}

TEST(FluidOrder, ConvectionOfEveryEighthStepIsSecondOrder)
{
  for (const Scheme& scheme : kSchemes) {
    ExactFlow flow = taylor_green();
    flow.dt_per_h = 0.0175;
    flow.steps_of_one_convection = 8;
    expect_second_order(flow, scheme, 32);
  }
}

TEST(FluidOrder, VorticesAcrossARefinedPatchAreSecondOrder)
{
  for (const Scheme& scheme : kSchemes)
    for (const int levels : {2, 3}) {
      ExactFlow flow = taylor_green();
      flow.levels = levels;
      expect_second_order(flow, scheme, levels == 2 ? 32 : 16);
    }
}

TEST(FluidOrder, DecayWithoutAdvectionIsSecondOrder)
{
  ExactFlow flow = taylor_green();
  flow.fluid.advection = Advection::none;  // the vortices decay alike, without pressure
  flow.velocity = [](int c, const Vec3& x, double t) {
    const double e = std::exp(-2 * kNu * t);
    if (c == 2) return 0.0;
    return c == 0 ? -std::cos(x[0]) * std::sin(x[1]) * e : std::sin(x[0]) * std::cos(x[1]) * e;
  };
  flow.pressure = [](const Vec3&, double) { return 0.0; };
  const FlowErrors coarse = flow_errors(flow, 16), fine = flow_errors(flow, 32);
  EXPECT_GT(std::log2(coarse.velocity.l2 / fine.velocity.l2), 1.9);
  EXPECT_LT(fine.pressure.l2, 1e-6);
}

}  // namespace
}  // namespace valsalva::ib3d
