#include "ib3d/output/probes.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::vector<double> pressure_at(const Level& level, const CellField<double>& p, double x, double y,
                                const std::vector<double>& z)
{
  std::vector<double> values(z.size(), 0.0);
  const Between bx(level, 0, x), by(level, 1, y);
  for (std::size_t m = 0; m < z.size(); ++m) {
    const Between bz(level, 2, z[m]);
    for (int corner = 0; corner < 8; ++corner) {
      const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
      const Int3 cell{bx.lower + a, by.lower + b, bz.lower + c};
      const double weight = (a ? bx.upper_weight : 1 - bx.upper_weight) *
                            (b ? by.upper_weight : 1 - by.upper_weight) *
                            (c ? bz.upper_weight : 1 - bz.upper_weight);
      for (int q = 0; q < level.local_count(); ++q)
        if (level.local_box(q).contains(cell)) values[m] += weight * p[q](cell[0], cell[1], cell[2]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                level.comm);
  return values;
}

double flow_through_disc(const Level& level, const MacField& u, double x, double y, double z, double r)
{
  const int k = static_cast<int>(std::lround(z / level.h));
  double flow = 0;
  for (int q = 0; q < level.local_count(); ++q) {
    const IndexBox box = owned_faces(level, level.local_box(q), 2);
    if (k < box.lo[2] || k >= box.hi[2]) continue;
    for (int j = box.lo[1]; j < box.hi[1]; ++j)
      for (int i = box.lo[0]; i < box.hi[0]; ++i)
        if (std::hypot((i + 0.5) * level.h - x, (j + 0.5) * level.h - y) <= r) flow += u(q, 2)(i, j, k);
  }
  flow *= level.h * level.h;
  MPI_Allreduce(MPI_IN_PLACE, &flow, 1, MPI_DOUBLE, MPI_SUM, level.comm);
  return flow;
}

double orifice_area(const std::vector<Vec3>& edges)
{
  double twice = 0;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    const Vec3 &a = edges[n], &b = edges[(n + 1) % edges.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return std::max(0.0, 0.5 * twice);
}

}  // namespace valsalva::ib3d
