#include "ib3d/grid/halo.hpp"

namespace valsalva::ib3d {

namespace {

std::vector<IndexBox> owned_boxes(const Level& level, std::size_t patch, Centring c)
{
  if (c == Centring::cell) return {level.patches[patch].box};
  return owned_faces(level, patch, static_cast<int>(c));
}

IndexBox ghosted_box(const IndexBox& cells, Centring c, int ghosts)
{
  return c == Centring::cell ? cells.grown(ghosts) : faces_of(cells.grown(ghosts), static_cast<int>(c));
}

}  // namespace

Halo::Halo(const Level& level, const std::vector<Centring>& centrings, int ghosts) : plan_(level.comm)
{
  const std::vector<int> local = level.local_numbers();
  for (std::size_t s = 0; s < centrings.size(); ++s)
    for (std::size_t o = 0; o < level.patches.size(); ++o) {
      const std::vector<IndexBox> owned = owned_boxes(level, o, centrings[s]);
      for (std::size_t g = 0; g < level.patches.size(); ++g)
        for_each_image(level, [&](const Int3& shift) {
          if (g == o && shift == Int3{}) return;
          const Int3 back{-shift[0], -shift[1], -shift[2]};
          const IndexBox wanted = ghosted_box(level.patches[g].box, centrings[s], ghosts);
          for (const IndexBox& box : owned)
            plan_.add(level.patches[o].owner, level.patches[g].owner,
                      {static_cast<int>(s), local[o], local[g],
                       intersect(box.shifted(shift), wanted).shifted(back), shift});
        });
    }
}

template <class T>
void Halo::fill(CellField<T>& field) const
{
  const auto at = [&](int patch, int) -> Array3<T>& { return field[patch]; };
  plan_.forward<T>(at, at);
}
template void Halo::fill(CellField<double>&) const;
template void Halo::fill(CellField<float>&) const;

void Halo::fill(MacField& field) const
{
  const auto at = [&](int patch, int slot) -> Array3<double>& { return field(patch, slot); };
  plan_.forward<double>(at, at);
}

void Halo::accumulate(MacField& field) const
{
  const auto at = [&](int patch, int slot) -> Array3<double>& { return field(patch, slot); };
  plan_.transpose<double>(at, at);
}

}  // namespace valsalva::ib3d
