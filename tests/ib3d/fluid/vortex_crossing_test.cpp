// An isolated vortex (no circulation: nothing but the stream a few radii away),
//     u = U - y w,  v = x w,  w = exp((1 - r^2/s^2)/2)/s,   x, y from its centre, largest swirl 1 at r = s,
// carried along x through the edge of a refined level. It is a steady solution of Euler's equations in its own frame, so
// what it leaves behind is the reflection of the edge.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kStream = 1.0, kCore = 0.5, kCoarse = 1.0 / 6, kStart = 6.5, kEnd = 10.5;
const Vec3 kSize{16, 6, 4 * kCoarse};

double vortex(int c, const Vec3& x, double centre)
{
  const double dx = x[0] - centre, dy = x[1] - 0.5 * kSize[1];
  const double w = std::exp(0.5 * (1 - (dx * dx + dy * dy) / (kCore * kCore))) / kCore;
  return c == 0 ? kStream - dy * w : c == 1 ? dx * w : 0.0;
}

/// Refined where from < x < to; largest |u - U| behind the vortex, five core radii and more from its centre, after it
/// has gone from kStart to kEnd.
double left_behind(Advection advection, double from, double to)
{
  const auto cells = [](double x) { return static_cast<int>(std::lround(2 * x / kCoarse)); };
  const IndexBox fine{{cells(from), 0, 0}, {cells(to), cells(kSize[1]), cells(kSize[2])}};
  const Hierarchy grid(periodic_box(kSize), kCoarse / 2, MPI_COMM_SELF, Refinement{{fine}});
  NavierStokes fluid(grid, {}, {1.0, 1e-4, advection}, {"multilevel", 1e-7, 100});
  CompositeMac u = composite_faces(grid);
  for (std::size_t l = 0; l < u.size(); ++l)
    fill_faces(grid.levels()[l], u[l], [&](int c, const Vec3& x) { return vortex(c, x, kStart); });
  fluid.set_velocity(u);
  const CompositeMac none = composite_faces(grid);
  const double dt = 0.15 * grid.finest().h;
  const long steps = std::lround((kEnd - kStart) / kStream / dt);
  for (long step = 0; step < steps; ++step) {
    fluid.begin_step(none, dt);
    fluid.solve_pressure({});
    fluid.finish_step({});
  }
  double largest = 0;
  for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
    const double h = grid.levels()[l].h, x = (i + 0.5) * h;
    if (x < 2 || x > kEnd - 5 * kCore) return;
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(fluid.u()[l](p, c)(i, j, k) - (c == 0 ? kStream : 0.0)));
  });
  return largest;
}

TEST(CoarseFineFace, AVortexCrossesItWithAReflectionBelowOnePercent)
{
  const double out = left_behind(Advection::xsppm7, 2, 8), in = left_behind(Advection::xsppm7, 8, 14);
  const double limited = left_behind(Advection::limited, 8, 14);
  RecordProperty("xsPPM7, out of and into the fine level; limited, into it",
                 fmt::format("{:.2e} {:.2e} {:.2e}", out, in, limited));
  EXPECT_LT(out, 0.01);
  EXPECT_LT(in, 0.01);
  EXPECT_LT(limited, 0.01);
}

}  // namespace
}  // namespace valsalva::ib3d
