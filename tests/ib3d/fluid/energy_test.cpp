// Stability at the largest CFL number that the step control allows: a three-dimensional flow with hardly any viscosity,
// stirred at scales of a few cells, must not gain energy.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {
namespace {

double energy(const Level& level, const MacField& u)
{
  double sum = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(level, p, c,
                          [&](int i, int j, int k) { sum += u(p, c)(i, j, k) * u(p, c)(i, j, k); });
  return sum;
}

TEST(NavierStokes, StirredFlowOfHighReynoldsNumberLosesEnergyAtTheLargestCourantNumber)
{
  for (const Advection advection : {Advection::limited, Advection::xsppm7}) {
    const Hierarchy grid(periodic_box({1, 1, 1}), 1.0 / 24, MPI_COMM_SELF);
    const Level& level = grid.finest();
    NavierStokes fluid(grid, {}, {1.0, 1e-6, advection}, {"multilevel", 1e-4, 100});
    MacField u(level), none(level);
    fill_faces(level, u, [](int c, const Vec3& x) {
      const double a = 2 * M_PI * x[0], b = 2 * M_PI * x[1], d = 2 * M_PI * x[2];
      return std::sin(3 * a + c) * std::cos(2 * b + 4 * d + 2 * c) + std::cos(5 * b - 4 * a + d + c) +
             0.5 * std::sin(7 * d + 6 * b - 3 * a * c);
    });
    fluid.set_velocity({u});
    double before = 0, first = 0, dt = 1e-4;
    for (int step = 0; step < 300; ++step) {
      dt = std::min(0.4 / fluid.courant_rate(), 1.15 * dt);
      fluid.begin_step(none, dt);
      fluid.solve_pressure({});
      fluid.finish_step({});
      const double now = energy(level, fluid.u()[0]);
      if (step == 0) first = now;
      if (step > 0) {
        ASSERT_LT(now, before) << step;
      }
      before = now;
    }
    RecordProperty(advection == Advection::limited ? "limited" : "xsPPM7",
                   fmt::format("{:.5f} of the energy after 300 steps", before / first));
  }
}

}  // namespace
}  // namespace valsalva::ib3d
