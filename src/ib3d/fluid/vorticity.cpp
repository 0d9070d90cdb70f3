#include "ib3d/fluid/vorticity.hpp"

#include <algorithm>
#include <map>

#include "common/comm.hpp"

namespace valsalva::ib3d {

namespace {

constexpr int kBlock = kBlockingFactor / 2;  // cells that one tile of the next finer level covers

void widen(IndexBox& box, const Int3& cell)
{
  for (std::size_t d = 0; d < 3; ++d) {
    box.lo[d] = std::min(box.lo[d], cell[d]);
    box.hi[d] = std::max(box.hi[d], cell[d] + 1);
  }
}

/// |curl u|^2 h^2 from the three edges that meet in the low corner of a cell.
double squared_curl(const MacField& u, int p, int i, int j, int k)
{
  const auto jump = [&](int c, int d) {
    Int3 below{i, j, k};
    --below[static_cast<std::size_t>(d)];
    return u(p, c)(i, j, k) - u(p, c)(below[0], below[1], below[2]);
  };
  const double x = jump(2, 1) - jump(1, 2), y = jump(0, 2) - jump(2, 0), z = jump(1, 0) - jump(0, 1);
  return x * x + y * y + z * z;
}

}  // namespace

std::vector<RefinedRegion> vortical_blocks(const Hierarchy& grid, const CompositeMac& u, double threshold)
{
  std::vector<RefinedRegion> regions;
  for (int l = 0; l + 1 < grid.level_count(); ++l) {
    const Level& level = grid.level(l);
    const double limit = threshold * threshold * level.h * level.h;
    std::map<Int3, IndexBox> blocks;
    for (int p = 0; p < level.local_count(); ++p) {
      IndexBox corners = level.local_box(p);  // those at the high walls too
      for (const Side side : {Side::x_hi, Side::y_hi, Side::z_hi})
        if (level.at_side(level.local_box(p), side)) corners = corners.extended(side, 1);
      for_each_index(corners, [&](int i, int j, int k) {
        if (squared_curl(u[static_cast<std::size_t>(l)], p, i, j, k) <= limit) return;
        Int3 cell{i, j, k};
        for (std::size_t d = 0; d < 3; ++d) cell[d] = std::min(cell[d], level.box.hi[d] - 1);
        const Int3 block{cell[0] / kBlock, cell[1] / kBlock, cell[2] / kBlock};
        const auto [found, is_new] = blocks.try_emplace(block, IndexBox{cell, cell});
        widen(found->second, cell);
      });
    }
    std::vector<IndexBox> mine;
    mine.reserve(blocks.size());
    for (const auto& [block, cells] : blocks) mine.push_back(cells);
    const auto point = [&](const Int3& c) { return Vec3{level.h * c[0], level.h * c[1], level.h * c[2]}; };
    for (const IndexBox& b : common::gather_lists(mine.data(), static_cast<int>(mine.size()), grid.comm()))
      regions.push_back({point(b.lo), point(b.hi), l + 1});
  }
  return regions;
}

}  // namespace valsalva::ib3d
