#include "ib3d/grid/refinement.hpp"

#include <cmath>

namespace valsalva::ib3d {

namespace {

IndexBox cells_of(const RefinedRegion& region, double h)
{
  IndexBox b;
  for (int d = 0; d < 3; ++d) {
    b.lo[static_cast<std::size_t>(d)] = static_cast<int>(std::floor(region.lo[d] / h + 1e-9));
    b.hi[static_cast<std::size_t>(d)] = static_cast<int>(std::ceil(region.hi[d] / h - 1e-9));
  }
  return b;
}

IndexBox support_of(const Vec3& x, double h, int margin)
{
  const int reach = kSupportCells + margin;
  return cells_of({x, x, 0}, h).grown(reach);
}

/// A distance of n finest cells in whole cells of a level so many levels below, rounded up.
int cells_of_finest(int n, int levels_below)
{
  return (n + (1 << levels_below) - 1) >> levels_below;
}

}  // namespace

Refinement refine(const Domain& domain, double h, const RefinementPolicy& policy, std::span<const Vec3> nodes,
                  std::span<const RefinedRegion> moving)
{
  const Int3 n = coarsest_cells(domain, h, policy.levels);
  Refinement boxes(static_cast<std::size_t>(policy.levels) - 1);
  for (int l = policy.levels - 1; l > 0; --l) {
    const double h_l = domain.size[0] / (n[0] << l);
    Tiles tags({{0, 0, 0}, {n[0] << l, n[1] << l, n[2] << l}});
    if (l == policy.levels - 1) {
      for (const Vec3& x : nodes) tags.add(support_of(x, h_l, policy.margin_cells), domain);
      if (policy.lumen) tags.fill_enclosed();
    } else {
      for (const IndexBox& finer : boxes[static_cast<std::size_t>(l)])
        tags.add(finer.coarsened().grown(kNestingBuffer), domain);
    }
    for (const RefinedRegion& r : policy.regions)
      if (r.level == l) tags.add(cells_of(r, h_l), domain);
    const int margin = cells_of_finest(policy.margin_cells, policy.levels - 1 - l);
    for (const RefinedRegion& r : moving)
      if (r.level == l) tags.add(cells_of(r, h_l).grown(margin), domain);
    boxes[static_cast<std::size_t>(l) - 1] = cluster(tags);
  }
  return boxes;
}

}  // namespace valsalva::ib3d
