#include "ib3d/grid/halo.hpp"

namespace valsalva::ib3d {

Halo::Halo(const Level& level, const std::vector<Centring>& centrings, int ghosts) : plan_(level.comm)
{
  for (const Centring c : centrings) {
    std::vector<std::vector<IndexBox>> owned;
    for (const Patch& p : level.patches) owned.push_back(owned_boxes(level, p.box, c));
    for_each_overlap(level, level, [&](std::size_t o, std::size_t g, const Int3& shift) {
      if (g == o && shift == Int3{}) return;
      const IndexBox wanted = indices_of(level.patches[g].box.grown(ghosts), c);
      for (const IndexBox& box : owned[o])
        plan_.add(level.patches[o], level.patches[g], shift, c, box, wanted);
    });
  }
}

}  // namespace valsalva::ib3d
