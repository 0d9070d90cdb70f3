// Flow through two open sides (z = 0 and z = pi: zero normal traction, no tangential slip), periodic along y,
// made exact by a body force:
//     v = -sin z sin y g,  w = -cos z cos y g,  p = rho sin z cos y g,
//     f = rho (u_t + u.grad u + 2 nu u) + grad p,   g = cos 2t.
// On the open sides v = 0, dw/dz = 0 and p = 0; half of each side takes fluid in, the other half lets it out.
#include <gtest/gtest.h>

#include <numbers>

#include "ib3d/fluid/order.hpp"
#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kPi = std::numbers::pi, kRho = 1.06, kNu = 0.05;

double rate(double t)
{
  return std::cos(2 * t);
}

ExactFlow between_open_sides()
{
  ExactFlow flow;
  flow.length = 2 * kPi;
  flow.domain = [](double h) {
    Domain domain = periodic_box({8 * h, 2 * kPi, kPi});
    domain.sides[4] = domain.sides[5] = SideKind::open;
    return domain;
  };
  flow.fluid = {kRho, kRho * kNu};
  flow.velocity = [](int c, const Vec3& x, double t) {
    if (c == 0) return 0.0;
    return -rate(t) * (c == 1 ? std::sin(x[2]) * std::sin(x[1]) : std::cos(x[2]) * std::cos(x[1]));
  };
  flow.pressure = [](const Vec3& x, double t) { return kRho * std::sin(x[2]) * std::cos(x[1]) * rate(t); };
  flow.force = [](int c, const Vec3& x, double t) {
    const double g = rate(t), dg = -2 * std::sin(2 * t);
    const double sy = std::sin(x[1]), cy = std::cos(x[1]), sz = std::sin(x[2]), cz = std::cos(x[2]);
    if (c == 1) return kRho * (-(dg + 2 * kNu * g) * sz * sy + g * g * sy * cy - sz * sy * g);
    if (c == 2) return kRho * (-(dg + 2 * kNu * g) * cz * cy - g * g * sz * cz + cz * cy * g);
    return 0.0;
  };
  flow.end_s = 1.0;
  return flow;
}

TEST(FluidOrder, OpenSidesAreSecondOrder)
{
  for (const Scheme& scheme : kSchemes) expect_second_order(between_open_sides(), scheme, 32);
}

}  // namespace
}  // namespace valsalva::ib3d
