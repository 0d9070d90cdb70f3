// A vortex that the stream carries through the edge of a refined level: what it leaves behind is the reflection of the
// edge.
#include "common/max_or_nan.hpp"
#include "ib3d/fluid/carried_vortex.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kStart = 6.5, kEnd = 10.5;

/// Refined where from < x < to; largest |u - U| behind the vortex, five core radii and more from its centre, after it
/// has gone from kStart to kEnd.
double left_behind(Advection advection, double from, double to)
{
  const auto cells = [](double x) { return static_cast<int>(std::lround(2 * x / kCoarse)); };
  const IndexBox fine{{cells(from), 0, 0}, {cells(to), cells(kVortexBox[1]), cells(kVortexBox[2])}};
  const Hierarchy grid(periodic_box(kVortexBox), kCoarse / 2, MPI_COMM_SELF, Refinement{{fine}});
  const CarriedVortex vortex(grid, kStart, advection);
  const double dt = 0.15 * grid.finest().h;
  const long steps = std::lround((kEnd - kStart) / kStream / dt);
  for (long step = 0; step < steps; ++step) vortex.step(dt);
  double largest = 0;
  for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
    const double h = grid.levels()[l].h, x = (i + 0.5) * h;
    if (x < 2 || x > kEnd - 5 * kCore) return;
    for (int c = 0; c < 3; ++c)
      largest = max_or_nan(largest, std::abs(vortex.fluid->u()[l](p, c)(i, j, k) - (c == 0 ? kStream : 0.0)));
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
