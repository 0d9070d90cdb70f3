#include "ib3d/grid/hierarchy.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/error.hpp"

namespace valsalva::ib3d {

namespace {

/// Cells along each direction, or a CaseError that names spacings that would do.
Int3 cells_of(const Domain& domain, double h)
{
  Int3 n{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double length = domain.size[static_cast<int>(d)];
    const double tiles = length / (kBlockingFactor * h);
    const int whole = std::max(1, static_cast<int>(std::lround(tiles)));
    n[d] = kBlockingFactor * whole;
    if (std::abs(tiles / whole - 1) > 0.005) {
      const int below = std::max(1, static_cast<int>(std::floor(tiles)));
      throw CaseError(
          "grid.finest_cm",
          fmt::format(
              "is {:.6g} cm, which does not divide the box: {:.6g} cm along {} would be {:.4g} cells, and "
              "the number of cells must be a multiple of {}. Use {:.6g} or {:.6g} cm",
              h, length, "xyz"[d], length / h, kBlockingFactor, length / (kBlockingFactor * below),
              length / (kBlockingFactor * (below + 1))));
    }
  }
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(domain.size[static_cast<int>(d)] / n[d] / (domain.size[0] / n[0]) - 1) > 1e-6)
      throw CaseError(
          "domain.size_cm",
          fmt::format("gives cells that are not cubes ({:.6g} cm along x, {:.6g} cm along {}); make the "
                      "sides multiples of one spacing",
                      domain.size[0] / n[0], domain.size[static_cast<int>(d)] / n[d], "xyz"[d]));
  return n;
}

/// Halves the box again and again across its longest side (in tiles) until there are `count` boxes.
void bisect(const IndexBox& box, int count, std::vector<IndexBox>& out)
{
  if (count == 1) {
    out.push_back(box);
    return;
  }
  int d = 2;
  for (int e : {1, 0})
    if (box.size(e) > box.size(d)) d = e;
  const auto dd = static_cast<std::size_t>(d);
  const int tiles = box.size(d) / kBlockingFactor;
  const int left_count = count / 2;
  const int cut = static_cast<int>(std::lround(static_cast<double>(tiles) * left_count / count));
  if (cut == 0 || cut == tiles)
    throw CaseError("grid.finest_cm",
                    fmt::format("leaves too few cells to share among {} boxes; run on fewer ranks", count));
  IndexBox left = box, right = box;
  left.hi[dd] = right.lo[dd] = box.lo[dd] + kBlockingFactor * cut;
  bisect(left, left_count, out);
  bisect(right, count - left_count, out);
}

}  // namespace

long Level::cell_count() const
{
  long n = 0;
  for (const Patch& p : patches) n += p.box.volume();
  return n;
}

bool Level::at_side(const IndexBox& b, int side) const
{
  const int d = side_direction(side);
  const auto dd = static_cast<std::size_t>(d);
  if (domain.periodic(d)) return false;
  return side_is_high(side) ? b.hi[dd] == box.hi[dd] : b.lo[dd] == box.lo[dd];
}

bool Level::can_coarsen() const
{
  for (const Patch& p : patches)
    for (std::size_t d = 0; d < 3; ++d)
      if (p.box.lo[d] % 2 != 0 || p.box.hi[d] % 2 != 0 || p.box.size(static_cast<int>(d)) < 4) return false;
  return true;
}

Level Level::coarsened() const
{
  Level c = *this;
  c.h = 2 * h;
  c.box = box.coarsened();
  for (Patch& p : c.patches) p.box = p.box.coarsened();
  return c;
}

Hierarchy::Hierarchy(const Domain& domain, double h, MPI_Comm comm, int boxes)
{
  const Int3 n = cells_of(domain, h);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);

  Level level;
  level.h = domain.size[0] / n[0];
  level.box = {{0, 0, 0}, n};
  level.domain = domain;
  level.comm = comm;
  std::vector<IndexBox> cut;
  bisect(level.box, std::max(boxes, ranks), cut);
  for (std::size_t b = 0; b < cut.size(); ++b) {
    const int owner = static_cast<int>(b * static_cast<std::size_t>(ranks) / cut.size());
    if (owner == rank) level.local.push_back(static_cast<int>(b));
    level.patches.push_back({cut[b], owner});
  }
  levels_.push_back(std::move(level));
}

}  // namespace valsalva::ib3d
