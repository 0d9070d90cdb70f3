// Where patches meet, periodic images included: the loops behind every exchange on the grid. An image of a level's cells is
// shifted by whole domains along its periodic directions.
#pragma once

#include <algorithm>
#include <vector>

#include "ib3d/grid/centring.hpp"
#include "ib3d/grid/hierarchy.hpp"

namespace valsalva::ib3d {

/// Calls f(shift) for the images of a level's cells, the identity included.
template <class F>
void for_each_image(const Level& level, F&& f)
{
  Int3 reach{};
  for (int d = 0; d < 3; ++d) reach[static_cast<std::size_t>(d)] = level.domain.periodic(d) ? 1 : 0;
  for_each_index({{-reach[0], -reach[1], -reach[2]}, {reach[0] + 1, reach[1] + 1, reach[2] + 1}},
                 [&](int x, int y, int z) {
                   f(Int3{x * level.box.size(0), y * level.box.size(1), z * level.box.size(2)});
                 });
}

/// Calls f(n, shift) for every patch of a level, number n in `patches`, and every image.
template <class F>
void for_each_patch_image(const Level& level, F&& f)
{
  for (std::size_t n = 0; n < level.patches.size(); ++n)
    for_each_image(level, [&](const Int3& shift) { f(n, shift); });
}

/// Calls f(a, b, shift) for every patch a of one level and b of another with the same cells (or the same level), and every
/// image: index i of a is i + shift of b.
template <class F>
void for_each_overlap(const Level& from, const Level& to, F&& f)
{
  for (std::size_t a = 0; a < from.patches.size(); ++a)
    for_each_patch_image(to, [&](std::size_t b, const Int3& shift) { f(a, b, shift); });
}

/// What no patch of the level, nor an image of one, holds of these disjoint boxes of indices of values.
inline std::vector<IndexBox> uncovered(std::vector<IndexBox> boxes, const Level& level,
                                       Centring c = Centring::cell)
{
  for_each_image(level, [&](const Int3& shift) {
    for (const Patch& p : level.patches) {
      const IndexBox hole = indices_of(p.box, c).shifted(shift);
      const auto meets = [&](const IndexBox& b) { return !intersect(b, hole).empty(); };
      if (std::any_of(boxes.begin(), boxes.end(), meets)) boxes = without(boxes, hole);
    }
  });
  return boxes;
}

}  // namespace valsalva::ib3d
