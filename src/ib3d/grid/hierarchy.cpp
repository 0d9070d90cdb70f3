#include "ib3d/grid/hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "ib3d/grid/recursive_bisection.hpp"

namespace valsalva::ib3d {

Int3 coarsest_cells(const Domain& domain, double h, int levels)
{
  const int block = kCoarsestBlockingFactor << (levels - 1);  // in cells of the finest level
  Int3 n{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double length = domain.size[static_cast<int>(d)];
    const double tiles = length / (block * h);
    const int whole = std::max(1, static_cast<int>(std::lround(tiles)));
    n[d] = kCoarsestBlockingFactor * whole;
    if (std::abs(tiles / whole - 1) > 0.005) {
      const int below = std::max(1, static_cast<int>(std::floor(tiles)));
      throw CaseError(
          "grid.finest_cm",
          fmt::format(
              "is {:.6g} cm, which does not divide the box: {:.6g} cm along {} would be {:.4g} cells, and "
              "the number of cells must be a multiple of {}. Use {:.6g} or {:.6g} cm",
              h, length, "xyz"[d], length / h, block, length / (block * below),
              length / (block * (below + 1))));
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

double finest_spacing(const Domain& domain, double h, int levels)
{
  return domain.size[0] / (coarsest_cells(domain, h, levels)[0] << (levels - 1));
}

const Patch* Level::patch_at(const Int3& cell) const
{
  const auto found =
      std::find_if(patches.begin(), patches.end(), [&](const Patch& p) { return p.box.contains(cell); });
  return found == patches.end() ? nullptr : &*found;
}

long Level::cell_count() const
{
  long n = 0;
  for (const Patch& p : patches) n += p.box.volume();
  return n;
}

bool Level::at_side(const IndexBox& b, Side side) const
{
  return !domain.periodic(axis(side)) && b.faces_at(side) == box.faces_at(side);
}

IndexBox Level::with_outside(const IndexBox& cells, IndexBox values, int reach) const
{
  for (const Side side : kSides)
    if (at_side(cells, side)) values = values.extended(side, reach);
  return values;
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
    : Hierarchy(domain, h, comm, Refinement{}, {}, boxes)
{
}

Hierarchy::Hierarchy(const Domain& domain, double h, MPI_Comm comm, const Refinement& refinement,
                     const std::vector<Vec3>& nodes, int boxes)
    : refinement_(refinement)
{
  const int levels = static_cast<int>(refinement.size()) + 1;
  const Int3 n = coarsest_cells(domain, h, levels);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);

  std::vector<LevelBoxes> all;
  for (int l = 0; l < levels; ++l) {
    const IndexBox whole{{0, 0, 0}, {n[0] << l, n[1] << l, n[2] << l}};
    all.push_back({domain.size[0] / whole.size(0), l == 0 ? kCoarsestBlockingFactor : kBlockingFactor,
                   l == 0 ? std::vector{whole} : refinement[static_cast<std::size_t>(l) - 1]});
    Level level;
    level.h = all.back().h;
    level.box = whole;
    level.domain = domain;
    level.comm = comm;
    levels_.push_back(std::move(level));
  }
  const int regions = std::max(boxes, ranks);
  const RecursiveBisection cuts(all, nodes, regions);
  for (std::size_t l = 0; l < levels_.size(); ++l)
    for (const RecursiveBisection::Piece& piece : cuts.cut(all[l])) {
      const int owner = static_cast<int>(static_cast<long>(piece.region) * ranks / regions);
      levels_[l].patches.push_back({piece.box, owner, owner == rank ? levels_[l].local_count() : -1});
      if (owner == rank) levels_[l].local.push_back(static_cast<int>(levels_[l].patches.size()) - 1);
    }
}

long Hierarchy::valid_cell_count() const
{
  long n = levels_[0].cell_count();
  for (std::size_t l = 1; l < levels_.size(); ++l) n += levels_[l].cell_count() * 7 / 8;
  return n;
}

bool Hierarchy::covered(int l, const Int3& cell) const
{
  return l + 1 < level_count() && level(l + 1).patch_at({2 * cell[0], 2 * cell[1], 2 * cell[2]}) != nullptr;
}

}  // namespace valsalva::ib3d
