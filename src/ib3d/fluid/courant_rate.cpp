#include "ib3d/fluid/courant_rate.hpp"

#include <algorithm>
#include <cmath>

#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

/// Over n cells in a row: a, b, c are their low faces, sy and sz lead to the high ones along y and z.
inline double fastest_in_row(const double* a, const double* b, const double* c, std::ptrdiff_t sy,
                             std::ptrdiff_t sz, int n)
{
  double fastest = 0, total = 0;
#pragma omp simd reduction(max : fastest) reduction(+ : total)
  for (int i = 0; i < n; ++i) {
    const double x = std::max(std::abs(a[i]), std::abs(a[i + 1]));
    const double y = std::max(std::abs(b[i]), std::abs(b[i + sy]));
    const double z = std::max(std::abs(c[i]), std::abs(c[i + sz]));
    fastest = std::max(fastest, x + y + z);
    total += x + y + z;
  }
  return largest_or_infinity(fastest, total);
}

}  // namespace

double courant_rate(const Level& level, const MacField& u, int patch, int k)
{
  const IndexBox& box = level.local_box(patch);
  double fastest = 0;
  for (int j = box.lo[1]; j < box.hi[1]; ++j)
    fastest =
        std::max(fastest, fastest_in_row(u(patch, 0).at(box.lo[0], j, k), u(patch, 1).at(box.lo[0], j, k),
                                         u(patch, 2).at(box.lo[0], j, k), u(patch, 1).stride(1),
                                         u(patch, 2).stride(2), box.size(0)));
  return fastest / level.h;
}

double courant_rate(const Level& level, const MacField& u)
{
  double largest = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int k = level.local_box(p).lo[2]; k < level.local_box(p).hi[2]; ++k)
      largest = std::max(largest, courant_rate(level, u, p, k));
  return largest;
}

}  // namespace valsalva::ib3d
