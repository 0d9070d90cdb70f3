#include "ib3d/fluid/pressure/openings.hpp"

#include <algorithm>

#include "common/error.hpp"

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
  const double x = (a + 0.5) * level.h - opening.centre[0];
  const double y = (b + 0.5) * level.h - opening.centre[1];
  return x * x + y * y <= opening.radius * opening.radius;
}

namespace {

/// First cell inside boundary face (a, b) of a side.
Int3 cell_at(const Level& level, int side, int a, int b)
{
  const int d = side_direction(side);
  Int3 cell{};
  cell[static_cast<std::size_t>(d)] = side_is_high(side) ? level.box.hi[static_cast<std::size_t>(d)] - 1
                                                         : level.box.lo[static_cast<std::size_t>(d)];
  cell[d == 0 ? 1 : 0] = a;
  cell[d == 2 ? 1 : 2] = b;
  return cell;
}

float share(const Hierarchy& grid, int l, int side, int a, int b, const std::vector<Opening>& openings)
{
  const Level& level = grid.level(l);
  if (level.domain.sides[static_cast<std::size_t>(side)] == SideKind::open) return 1.0f;
  if (grid.covered(l, cell_at(level, side, a, b))) {
    float sum = 0;
    for (int m = 0; m < 4; ++m) sum += share(grid, l + 1, side, 2 * a + (m & 1), 2 * b + (m >> 1), openings);
    return coarse_share(sum);
  }
  for (const Opening& o : openings)
    if (o.side == side && in_disc(o, level, a, b)) return 1.0f;
  return 0.0f;
}

}  // namespace

std::vector<SidePlane<float>> pressure_shares(const Hierarchy& grid, int l, int local_patch,
                                              const std::vector<Opening>& openings)
{
  std::vector<SidePlane<float>> planes;
  const Level& level = grid.level(l);
  const IndexBox& cells = level.local_box(local_patch);
  for (int side = 0; side < kSideCount; ++side) {
    if (!level.at_side(cells, side)) continue;
    SidePlane<float> plane(cells, side, 0.0f);
    for (int b = plane.lo2; b < plane.lo2 + plane.n2; ++b)
      for (int a = plane.lo1; a < plane.lo1 + plane.n1; ++a)
        plane(a, b) = share(grid, l, side, a, b, openings);
    planes.push_back(std::move(plane));
  }
  return planes;
}

OpeningFaces::OpeningFaces(const Hierarchy& grid, const std::vector<Opening>& openings) : comm_(grid.comm())
{
  for (const Level& level : grid.levels()) h_.push_back(level.h);
  for (const Opening& o : openings) {
    const bool high = side_is_high(o.side);
    outward_.push_back(high ? 1.0 : -1.0);
    std::vector<Face>& faces = faces_.emplace_back();
    double area = 0;
    for (int l = 0; l < grid.level_count(); ++l) {
      const Level& level = grid.level(l);
      const int k = high ? level.box.hi[2] : level.box.lo[2];
      for (int p = 0; p < level.local_count(); ++p) {
        const IndexBox& cells = level.local_box(p);
        if (!level.at_side(cells, o.side)) continue;
        for (int j = cells.lo[1]; j < cells.hi[1]; ++j)
          for (int i = cells.lo[0]; i < cells.hi[0]; ++i) {
            if (!in_disc(o, level, i, j) || grid.covered(l, cell_at(level, o.side, i, j))) continue;
            faces.push_back({l, p, i, j, k});
            area += level.h * level.h;
          }
      }
    }
    area_.push_back(area);
  }
  MPI_Allreduce(MPI_IN_PLACE, area_.data(), static_cast<int>(area_.size()), MPI_DOUBLE, MPI_SUM, comm_);
  for (std::size_t m = 0; m < area_.size(); ++m)
    if (area_[m] == 0)
      throw CaseError("opening.radius_cm",
                      "of \"" + openings[m].name +
                          "\" is so small that no face of the grid lies in the disc; use a larger "
                          "radius or a finer grid");
}

}  // namespace valsalva::ib3d
