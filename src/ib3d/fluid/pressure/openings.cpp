#include "ib3d/fluid/pressure/openings.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace valsalva::ib3d {

bool in_disc(const Opening& opening, const Level& level, int a, int b)
{
  const double x = (a + 0.5) * level.h - opening.centre[first_tangent(opening.side)];
  const double y = (b + 0.5) * level.h - opening.centre[second_tangent(opening.side)];
  return x * x + y * y <= opening.radius * opening.radius;
}

namespace {

float share(const Hierarchy& grid, int l, Side side, int a, int b, const std::vector<Opening>& openings)
{
  const Level& level = grid.level(l);
  if (level.domain.kind(side) == SideKind::open) return 1.0f;
  if (grid.covered(l, place_at(side, level.box.cells_inside(side), a, b))) {
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
  for (const Side side : kSides) {
    if (!level.at_side(cells, side)) continue;
    SidePlane<float> plane(cells, side, 0.0f);
    plane.for_each(0, [&](const Int3&, int a, int b) { plane(a, b) = share(grid, l, side, a, b, openings); });
    planes.push_back(std::move(plane));
  }
  return planes;
}

OpeningFaces::OpeningFaces(const Hierarchy& grid, const std::vector<Opening>& openings) : comm_(grid.comm())
{
  for (const Level& level : grid.levels()) h_.push_back(level.h);
  for (const Opening& o : openings) {
    std::vector<Face>& faces = faces_.emplace_back();
    double area = 0;
    for (int l = 0; l < grid.level_count(); ++l) {
      const Level& level = grid.level(l);
      const int face = level.box.faces_at(o.side), inside = level.box.cells_inside(o.side);
      for (int p = 0; p < level.local_count(); ++p) {
        if (!level.at_side(level.local_box(p), o.side)) continue;
        SidePlane<float>(level.local_box(p), o.side, 0).for_each(face, [&](const Int3& at, int a, int b) {
          if (!in_disc(o, level, a, b) || grid.covered(l, place_at(o.side, inside, a, b))) return;
          faces.push_back({l, p, o.side, at, place_at(o.side, face - 1, a, b)});
          area += level.h * level.h;
        });
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
