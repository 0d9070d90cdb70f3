#include "ib3d/fluid/openings.hpp"

#include <algorithm>

namespace valsalva::ib3d {

template <class T>
SidePlane<T>::SidePlane(const IndexBox& cells, int side_number, T fill) : side(side_number)
{
  const int d = side_direction(side);
  t1 = d == 0 ? 1 : 0;
  t2 = d == 2 ? 1 : 2;
  lo1 = cells.lo[static_cast<std::size_t>(t1)];
  lo2 = cells.lo[static_cast<std::size_t>(t2)];
  n1 = cells.size(t1);
  n2 = cells.size(t2);
  value.assign(static_cast<std::size_t>(n1) * static_cast<std::size_t>(n2), fill);
}

template <class T>
T SidePlane<T>::clamped(int a, int b) const
{
  return (*this)(std::clamp(a, lo1, lo1 + n1 - 1), std::clamp(b, lo2, lo2 + n2 - 1));
}

template struct SidePlane<float>;
template struct SidePlane<double>;

bool in_disc(const Opening& opening, const Level& level, int a, int b)
{
  const double x = (a + 0.5) * level.h - opening.center[0];
  const double y = (b + 0.5) * level.h - opening.center[1];
  return x * x + y * y <= opening.radius * opening.radius;
}

std::vector<SidePlane<float>> pressure_shares(const Level& level, int local_patch,
                                              const std::vector<Opening>& openings)
{
  std::vector<SidePlane<float>> planes;
  const IndexBox& cells = level.local_box(local_patch);
  for (int side = 0; side < kSideCount; ++side) {
    if (!level.at_side(cells, side)) continue;
    const bool open = level.domain.sides[static_cast<std::size_t>(side)] == SideKind::open;
    SidePlane<float> plane(cells, side, open ? 1.0f : 0.0f);
    for (const Opening& o : openings)
      if (o.side == side)
        for (int b = plane.lo2; b < plane.lo2 + plane.n2; ++b)
          for (int a = plane.lo1; a < plane.lo1 + plane.n1; ++a)
            if (in_disc(o, level, a, b)) plane(a, b) = 1.0f;
    planes.push_back(std::move(plane));
  }
  return planes;
}

double disc_area(const Opening& opening, const Level& level)
{
  long faces = 0;
  for (int b = level.box.lo[1]; b < level.box.hi[1]; ++b)
    for (int a = level.box.lo[0]; a < level.box.hi[0]; ++a) faces += in_disc(opening, level, a, b) ? 1 : 0;
  return static_cast<double>(faces) * level.h * level.h;
}

std::vector<double> flow_through(const std::vector<Opening>& openings, const Level& level, const MacField& u)
{
  std::vector<double> flow(openings.size(), 0.0);
  for (std::size_t m = 0; m < openings.size(); ++m) {
    const Opening& o = openings[m];
    const bool high = side_is_high(o.side);
    for (int p = 0; p < level.local_count(); ++p) {
      const IndexBox& cells = level.local_box(p);
      if (!level.at_side(cells, o.side)) continue;
      const int k = high ? level.box.hi[2] : level.box.lo[2];
      for (int j = cells.lo[1]; j < cells.hi[1]; ++j)
        for (int i = cells.lo[0]; i < cells.hi[0]; ++i)
          if (in_disc(o, level, i, j)) flow[m] += u(p, 2)(i, j, k);
    }
    flow[m] *= (high ? 1.0 : -1.0) * level.h * level.h;
  }
  MPI_Allreduce(MPI_IN_PLACE, flow.data(), static_cast<int>(flow.size()), MPI_DOUBLE, MPI_SUM, level.comm);
  return flow;
}

}  // namespace valsalva::ib3d
