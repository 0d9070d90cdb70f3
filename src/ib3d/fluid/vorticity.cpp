#include "ib3d/fluid/vorticity.hpp"

#include <algorithm>
#include <set>

#include "common/comm.hpp"

namespace valsalva::ib3d {

namespace {

constexpr int kBlock = kBlockingFactor / 2;  // cells that one tile of the next finer level covers

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
    std::set<Int3> blocks;
    for (int p = 0; p < level.local_count(); ++p) {
      IndexBox corners = level.local_box(p);  // those at the high walls too
      for (std::size_t d = 0; d < 3; ++d)
        corners.hi[d] += level.at_side(level.local_box(p), static_cast<int>(2 * d + 1)) ? 1 : 0;
      for_each_index(corners, [&](int i, int j, int k) {
        if (squared_curl(u[static_cast<std::size_t>(l)], p, i, j, k) <= limit) return;
        Int3 block{i, j, k};
        for (std::size_t d = 0; d < 3; ++d) block[d] = std::min(block[d], level.box.hi[d] - 1) / kBlock;
        blocks.insert(block);
      });
    }
    const std::vector<Int3> mine(blocks.begin(), blocks.end());
    const double size = kBlock * level.h;
    for (const Int3& b : common::gather_lists(mine.data(), static_cast<int>(mine.size()), grid.comm())) {
      const Vec3 lo{b[0] * size, b[1] * size, b[2] * size};
      regions.push_back({lo, lo + Vec3{size, size, size}, l + 1});
    }
  }
  return regions;
}

}  // namespace valsalva::ib3d
