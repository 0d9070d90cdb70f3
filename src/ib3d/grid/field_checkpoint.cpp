#include "ib3d/grid/field_checkpoint.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace valsalva::ib3d {

namespace {

std::vector<int> corners_of(const std::vector<IndexBox>& boxes)
{
  std::vector<int> corners;
  for (const IndexBox& b : boxes)
    corners.insert(corners.end(), {b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]});
  return corners;
}

std::vector<IndexBox> boxes_from(const std::vector<int>& corners)
{
  std::vector<IndexBox> boxes;
  for (std::size_t i = 0; i + 6 <= corners.size(); i += 6)
    boxes.push_back(
        {{corners[i], corners[i + 1], corners[i + 2]}, {corners[i + 3], corners[i + 4], corners[i + 5]}});
  return boxes;
}

/// The values of one centring of a CellField<double> or MacField, by the disjoint boxes that every patch owns.
template <class Field>
void save_or_restore(Checkpoint& c, const std::string& name, const Level& level, Centring centring,
                     Field& field)
{
  const auto values_of = [&](int p) -> Array3<double>& { return field(p, centring); };
  std::vector<IndexBox> boxes, mine;
  std::vector<int> patch_of;  ///< local number, per entry of `mine`
  for (const Patch& patch : level.patches)
    for (const IndexBox& b : owned_boxes(level, patch.box, centring)) {
      boxes.push_back(b);
      if (patch.local < 0) continue;
      mine.push_back(b);
      patch_of.push_back(patch.local);
    }
  std::vector<int> corners = corners_of(boxes);
  c(name + "_boxes", corners);
  const std::vector<IndexBox> stored = boxes_from(corners);

  // Writing, this rank's share are its own boxes; reading, all stored boxes that meet one of them.
  std::vector<IndexBox> shared;
  std::vector<Slab> slabs;
  std::int64_t total = 0;
  for (const IndexBox& b : stored) {
    const bool wanted = std::any_of(mine.begin(), mine.end(), [&](const IndexBox& m) {
      return c.reading() ? !intersect(b, m).empty() : b == m;
    });
    if (wanted) {
      shared.push_back(b);
      slabs.push_back({{total}, {b.volume()}});
    }
    total += b.volume();
  }

  std::vector<double> values;
  if (!c.reading())
    for (std::size_t p = 0; p < mine.size(); ++p)
      for_each_index(mine[p],
                     [&](int i, int j, int k) { values.push_back(values_of(patch_of[p])(i, j, k)); });
  c.spread(name, total, slabs, values);
  if (!c.reading()) return;

  std::int64_t missing = 0;
  for (const IndexBox& m : mine) missing += m.volume();
  const double* of_box = values.data();
  for (const IndexBox& b : shared) {
    for (std::size_t p = 0; p < mine.size(); ++p) {
      const IndexBox common = intersect(b, mine[p]);
      missing -= common.volume();
      for_each_index(common, [&](int i, int j, int k) {
        values_of(patch_of[p])(i, j, k) =
            of_box[(i - b.lo[0]) + static_cast<long>(b.size(0)) *
                                       ((j - b.lo[1]) + static_cast<long>(b.size(1)) * (k - b.lo[2]))];
      });
    }
    of_box += b.volume();
  }
  MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_INT64_T, MPI_MAX, level.comm);
  if (missing != 0) throw IoError(c.path() + ": " + name + " does not cover the grid of this case");
}

}  // namespace

void save_or_restore(Checkpoint& c, const std::string& name, Refinement& boxes)
{
  int levels = static_cast<int>(boxes.size());
  c(name + "/refined_levels", levels);
  boxes.resize(static_cast<std::size_t>(levels));
  for (std::size_t l = 0; l < boxes.size(); ++l) {
    std::vector<int> corners = corners_of(boxes[l]);
    c(name + "/boxes_of_level_" + std::to_string(l + 1), corners);
    boxes[l] = boxes_from(corners);
  }
}

void save_or_restore(Checkpoint& c, const std::string& name, const Level& level, CellField<double>& field)
{
  save_or_restore(c, name, level, Centring::cell, field);
}

void save_or_restore(Checkpoint& c, const std::string& name, const Level& level, MacField& field)
{
  for (int d = 0; d < 3; ++d) save_or_restore(c, name + "_" + "xyz"[d], level, face_normal_to(d), field);
}

}  // namespace valsalva::ib3d
