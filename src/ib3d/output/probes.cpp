#include "ib3d/output/probes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/max_or_nan.hpp"

namespace valsalva::ib3d {

namespace {

/// Lower cell of the pair around `at` (cm) along direction d, and the weight of the upper one.
struct Between {
  int lower;
  double upper_weight;
  Between(const Level& level, int d, double at)
  {
    const auto dd = static_cast<std::size_t>(d);
    const double s =
        std::clamp(at / level.h - 0.5, static_cast<double>(level.box.lo[dd]), level.box.hi[dd] - 1.0);
    lower = std::min(static_cast<int>(std::floor(s)), level.box.hi[dd] - 2);
    upper_weight = s - lower;
  }
};

/// The finest level whose boxes hold the eight cells around a point, and their weights.
struct Around {
  int level;
  std::array<Int3, 8> cell;
  std::array<double, 8> weight;
  Around(const Hierarchy& grid, const Vec3& x)
  {
    for (level = grid.level_count() - 1; level >= 0; --level) {
      const Level& at = grid.level(level);
      const Between b[3] = {{at, 0, x[0]}, {at, 1, x[1]}, {at, 2, x[2]}};
      bool inside = true;
      for (std::size_t c = 0; c < 8; ++c) {
        weight[c] = 1;
        for (std::size_t d = 0; d < 3; ++d) {
          const bool upper = ((c >> d) & 1) != 0;
          cell[c][d] = b[d].lower + (upper ? 1 : 0);
          weight[c] *= upper ? b[d].upper_weight : 1 - b[d].upper_weight;
        }
        inside = inside && at.patch_at(cell[c]) != nullptr;
      }
      if (inside) return;
    }
  }
};

}  // namespace

std::vector<double> pressure_at(const Hierarchy& grid, const CompositeCells<double>& p,
                                const std::vector<Vec3>& points)
{
  std::vector<double> values(points.size(), 0.0);
  for (std::size_t m = 0; m < points.size(); ++m) {
    const Around around(grid, points[m]);
    const Level& level = grid.level(around.level);
    for (std::size_t c = 0; c < 8; ++c)
      for (int q = 0; q < level.local_count(); ++q)
        if (const Int3& at = around.cell[c]; level.local_box(q).contains(at))
          values[m] += around.weight[c] * p[static_cast<std::size_t>(around.level)][q](at[0], at[1], at[2]);
  }
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                grid.comm());
  return values;
}

double flow_through_disc(const Hierarchy& grid, const CompositeMac& u, int d, const Vec3& centre, double r)
{
  const Side side = kSides[static_cast<std::size_t>(2 * d)];
  const int t1 = first_tangent(side), t2 = second_tangent(side);
  double flow = 0;
  for (int l = 0; l < grid.level_count(); ++l) {
    const Level& level = grid.level(l);
    const auto distance = [&](const Int3& at, int t) {
      return (at[static_cast<std::size_t>(t)] + 0.5) * level.h - centre[t];
    };
    const auto dd = static_cast<std::size_t>(d);
    const int face = static_cast<int>(std::lround(centre[d] / grid.level(0).h))
                     << l;  // the same plane on all levels
    for (int q = 0; q < level.local_count(); ++q) {
      const IndexBox& box = level.local_box(q);
      const bool last = face == level.box.hi[dd] && face == box.hi[dd];
      if (!last && (face < box.lo[dd] || face >= box.hi[dd])) continue;
      for_each_index(box.with_range(d, face, 1), [&](int i, int j, int k) {
        Int3 cell{i, j, k};
        if (last) --cell[dd];
        if (std::hypot(distance(cell, t1), distance(cell, t2)) <= r && !grid.covered(l, cell))
          flow += level.h * level.h * u[static_cast<std::size_t>(l)](q, d)(i, j, k);
      });
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &flow, 1, MPI_DOUBLE, MPI_SUM, grid.comm());
  return flow;
}

double orifice_area(const std::vector<Vec3>& edges)
{
  double twice = 0;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    const Vec3 &a = edges[n], &b = edges[(n + 1) % edges.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return max_or_nan(0.0, 0.5 * twice);
}

}  // namespace valsalva::ib3d
