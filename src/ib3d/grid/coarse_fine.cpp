#include "ib3d/grid/coarse_fine.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

constexpr int kShadowGhosts = kMacGhosts / 2 + 2;
constexpr int kCells = 3;  ///< "component" of cell-centred values: no direction is normal

/// Weights of the coarse values first, first + 1, ... that give fine value i along one direction.
struct Taps {
  int first, count;
  double weight[4];
};

Taps taps_of(bool normal, int i)
{
  const int c = half_below(i);
  const bool odd = (i & 1) != 0;
  if (!normal) {
    const double s = odd ? 0.125 : -0.125;
    return {c - 1, 3, {-s, 1.0, s, 0.0}};
  }
  if (!odd) return {c, 1, {1.0, 0.0, 0.0, 0.0}};
  return {c - 1, 4, {-0.0625, 0.5625, 0.5625, -0.0625}};
}

/// Coarse values that fine values of this component read.
IndexBox footprint(const IndexBox& fine, int component)
{
  IndexBox b;
  for (int d = 0; d < 3; ++d) {
    const auto dd = static_cast<std::size_t>(d);
    b.lo[dd] = half_below(fine.lo[dd]) - 1;
    b.hi[dd] = half_below(fine.hi[dd] - 1) + (d == component ? 3 : 2);
  }
  return b;
}

/// sum = the combination of rows `step` apart that the taps name; row: the first of them.
inline void mix_rows(double* __restrict sum, const double* __restrict row, std::ptrdiff_t step,
                     const Taps& taps, int n)
{
  const double a = taps.weight[0], b = taps.weight[1], c = taps.weight[2];
  if (taps.count == 1)
    for (int i = 0; i < n; ++i) sum[i] = row[i];
  else if (taps.count == 3)
    for (int i = 0; i < n; ++i) sum[i] = row[i + step] + a * row[i] + c * row[i + 2 * step];
  else
    for (int i = 0; i < n; ++i)
      sum[i] = a * (row[i] + row[i + 3 * step]) + b * (row[i + step] + row[i + 2 * step]);
}

/// Fine values of index lo to hi - 1 along a row from coarse ones; m: that of coarse index 0.
inline void expand_row(double* __restrict fine, const double* __restrict m, bool normal, int lo, int hi)
{
  const auto at = [&](int i) -> double& { return fine[i - lo]; };
  const int even = lo + (lo & 1), odd = lo + 1 - (lo & 1);
  if (normal) {
    for (int i = even; i < hi; i += 2) at(i) = m[half_below(i)];
    for (int i = odd; i < hi; i += 2) {
      const double* c = m + half_below(i);
      at(i) = 0.5625 * (c[0] + c[1]) - 0.0625 * (c[-1] + c[2]);
    }
    return;
  }
  for (int i = even; i < hi; i += 2) {
    const double* c = m + half_below(i);
    at(i) = c[0] - 0.125 * (c[1] - c[-1]);
  }
  for (int i = odd; i < hi; i += 2) {
    const double* c = m + half_below(i);
    at(i) = c[0] + 0.125 * (c[1] - c[-1]);
  }
}

/// One direction after the other: z into a plane of coarse rows, y into a row, x.
void interpolate_box(const Array3<double>& coarse, Array3<double>& fine, const IndexBox& box, int component)
{
  const IndexBox from = footprint(box, component);
  const int n = from.size(0), rows = from.size(1);
  std::vector<double> plane(static_cast<std::size_t>(n) * static_cast<std::size_t>(rows)),
      row(static_cast<std::size_t>(n));
  for (int k = box.lo[2]; k < box.hi[2]; ++k) {
    const Taps z = taps_of(component == 2, k);
    for (int j = 0; j < rows; ++j)
      mix_rows(plane.data() + static_cast<std::ptrdiff_t>(j) * n,
               coarse.at(from.lo[0], from.lo[1] + j, z.first), coarse.stride(2), z, n);
    for (int j = box.lo[1]; j < box.hi[1]; ++j) {
      const Taps y = taps_of(component == 1, j);
      mix_rows(row.data(), plane.data() + static_cast<std::ptrdiff_t>(y.first - from.lo[1]) * n, n, y, n);
      expand_row(fine.at(box.lo[0], j, k), row.data() - from.lo[0], component == 0, box.lo[0], box.hi[0]);
    }
  }
}

/// Mean of the four fine faces that make up a coarse one, along a row.
inline void mean_of_faces(double* __restrict out, const double* __restrict a, std::ptrdiff_t s1,
                          std::ptrdiff_t s2, int n)
{
  for (int i = 0; i < n; ++i)
    out[i] = 0.25 * ((a[2 * i] + a[2 * i + s1]) + (a[2 * i + s2] + a[2 * i + s1 + s2]));
}

template <class T>
inline void mean_of_cells(T* __restrict out, const T* __restrict a, std::ptrdiff_t sy, std::ptrdiff_t sz,
                          int n)
{
  for (int i = 0; i < n; ++i)
    out[i] = static_cast<T>(0.125) *
             (((a[2 * i] + a[2 * i + 1]) + (a[2 * i + sy] + a[2 * i + 1 + sy])) +
              ((a[2 * i + sz] + a[2 * i + 1 + sz]) + (a[2 * i + sy + sz] + a[2 * i + 1 + sy + sz])));
}

/// The faces of direction d at both ends of a box.
std::array<IndexBox, 2> end_planes(const IndexBox& cells, int d)
{
  const auto dd = static_cast<std::size_t>(d);
  IndexBox low = faces_of(cells, d), high = low;
  low.hi[dd] = low.lo[dd] + 1;
  high.lo[dd] = high.hi[dd] - 1;
  return {low, high};
}

/// The values of a patch that may be read: its own and those beyond the sides of the domain.
IndexBox readable(const Level& level, const IndexBox& cells, int component)
{
  return component == kCells ? level.with_outside(cells, cells, 1)
                             : level.with_outside(cells, faces_of(cells, component), kMacGhosts);
}

}  // namespace

CoarseFine::CoarseFine(const Level& coarse, const Level& fine, int ghosts)
    : coarse_(coarse),
      fine_(fine),
      coarsened_(fine.coarsened()),
      covered_(static_cast<std::size_t>(coarse.local_count())),
      down_faces_(coarse.comm),
      down_edges_(coarse.comm),
      down_cells_(coarse.comm),
      up_ghosts_(coarse.comm),
      shadow_(coarsened_, kShadowGhosts),
      cells_(coarsened_, kShadowGhosts),
      cells_float_(coarsened_, 0)
{
  const std::vector<int> here = coarse_.local_numbers(), there = fine_.local_numbers();
  for (std::size_t f = 0; f < fine_.patches.size(); ++f)
    for (std::size_t c = 0; c < coarse_.patches.size(); ++c)
      for_each_image(coarse_, [&](const Int3& shift) {
        const Int3 back{-shift[0], -shift[1], -shift[2]};
        const IndexBox from = coarsened_.patches[f].box, to = coarse_.patches[c].box.shifted(back);
        const int from_owner = fine_.patches[f].owner, to_owner = coarse_.patches[c].owner;
        for (int d = 0; d < 3; ++d) {
          down_faces_.add(from_owner, to_owner,
                          {d, there[f], here[c], intersect(faces_of(from, d), faces_of(to, d)), shift});
          for (const IndexBox& side : end_planes(from, d))
            down_edges_.add(from_owner, to_owner,
                            {d, there[f], here[c], intersect(side, faces_of(to, d)), shift});
        }
        const IndexBox common = intersect(from, to);
        down_cells_.add(from_owner, to_owner, {0, there[f], here[c], common, shift});
        if (here[c] >= 0 && !common.empty())
          covered_[static_cast<std::size_t>(here[c])].push_back(common.shifted(shift));
      });

  std::vector<GhostPart> all;
  for (std::size_t f = 0; f < fine_.patches.size(); ++f)
    for (int d = 0; d < 3; ++d) {
      IndexBox inside = fine_.box;  // in periodic directions everything is inside
      for (int e = 0; e < 3; ++e)
        if (fine_.domain.periodic(e)) {
          inside.lo[static_cast<std::size_t>(e)] -= ghosts;
          inside.hi[static_cast<std::size_t>(e)] += ghosts;
        }
      std::vector<IndexBox> rest{
          intersect(faces_of(fine_.patches[f].box.grown(ghosts), d), faces_of(inside, d))};
      for_each_image(fine_, [&](const Int3& shift) {
        for (const Patch& p : fine_.patches) rest = without(rest, faces_of(p.box, d).shifted(shift));
      });
      for (const IndexBox& faces : rest) all.push_back({static_cast<int>(f), d, faces});
    }
  up_ghosts_ = plan_footprints(all);
  for (const GhostPart& g : all)
    if (const int p = there[static_cast<std::size_t>(g.patch)]; p >= 0)
      ghosts_.push_back({p, g.component, g.faces});
}

/// `parts` by global patch number.
CopyPlan CoarseFine::plan_footprints(const std::vector<GhostPart>& parts) const
{
  CopyPlan plan(coarse_.comm);
  const std::vector<int> here = coarse_.local_numbers(), there = fine_.local_numbers();
  for (const GhostPart& part : parts) {
    const auto f = static_cast<std::size_t>(part.patch);
    std::vector<IndexBox> wanted{footprint(part.faces, part.component)};
    for (std::size_t c = 0; c < coarse_.patches.size(); ++c)
      for_each_image(coarse_, [&](const Int3& shift) {
        const Int3 back{-shift[0], -shift[1], -shift[2]};
        const IndexBox source = readable(coarse_, coarse_.patches[c].box, part.component).shifted(shift);
        for (const IndexBox& w : wanted)
          plan.add(coarse_.patches[c].owner, fine_.patches[f].owner,
                   {part.component == kCells ? 0 : part.component, here[c], there[f],
                    intersect(w, source).shifted(back), shift});
        wanted = without(wanted, source);
      });
  }
  return plan;
}

void CoarseFine::fetch(const CopyPlan& plan, const MacField& coarse)
{
  plan.forward<double>([&](int p, int d) -> const Array3<double>& { return coarse(p, d); },
                       [&](int p, int d) -> Array3<double>& { return shadow_(p, d); });
}

void CoarseFine::average(const MacField& fine, int patch, int component, const IndexBox& faces)
{
  const Array3<double>& a = fine(patch, component);
  Array3<double>& means = shadow_(patch, component);
  const std::ptrdiff_t s1 = a.stride(component == 0 ? 1 : 0), s2 = a.stride(component == 2 ? 1 : 2);
  for_each_row(faces, [&](int j, int k) {
    mean_of_faces(means.at(faces.lo[0], j, k), a.at(2 * faces.lo[0], 2 * j, 2 * k), s1, s2, faces.size(0));
  });
}

void CoarseFine::send_down(const CopyPlan& plan, MacField& coarse)
{
  plan.forward<double>([&](int p, int d) -> const Array3<double>& { return shadow_(p, d); },
                       [&](int p, int d) -> Array3<double>& { return coarse(p, d); });
}

void CoarseFine::average_down(const MacField& fine, MacField& coarse)
{
  for (int p = 0; p < fine_.local_count(); ++p)
    for (int d = 0; d < 3; ++d) average(fine, p, d, faces_of(coarsened_.local_box(p), d));
  send_down(down_faces_, coarse);
}

void CoarseFine::average_down_edges(const MacField& fine, MacField& coarse)
{
  for (int p = 0; p < fine_.local_count(); ++p)
    for (int d = 0; d < 3; ++d)
      for (const IndexBox& side : end_planes(coarsened_.local_box(p), d)) average(fine, p, d, side);
  send_down(down_edges_, coarse);
}

template <class T>
void CoarseFine::average_down(const CellField<T>& fine, CellField<T>& coarse)
{
  CellField<T>& means = this->means(T{});
  for (int p = 0; p < fine_.local_count(); ++p) {
    const IndexBox& box = coarsened_.local_box(p);
    for_each_row(box, [&](int j, int k) {
      mean_of_cells(means[p].at(box.lo[0], j, k), fine[p].at(2 * box.lo[0], 2 * j, 2 * k), fine[p].stride(1),
                    fine[p].stride(2), box.size(0));
    });
  }
  down_cells_.forward<T>([&](int p, int) -> const Array3<T>& { return means[p]; },
                         [&](int p, int) -> Array3<T>& { return coarse[p]; });
}
template void CoarseFine::average_down(const CellField<float>&, CellField<float>&);
template void CoarseFine::average_down(const CellField<double>&, CellField<double>&);

void CoarseFine::fill_ghosts(const MacField& coarse, MacField& fine)
{
  fetch(up_ghosts_, coarse);
  for (const GhostPart& g : ghosts_)
    interpolate_box(shadow_(g.patch, g.component), fine(g.patch, g.component), g.faces, g.component);
}

void CoarseFine::interpolate(const MacField& coarse, MacField& fine)
{
  std::vector<GhostPart> all;
  for (std::size_t f = 0; f < fine_.patches.size(); ++f)
    for (int d = 0; d < 3; ++d) all.push_back({static_cast<int>(f), d, faces_of(fine_.patches[f].box, d)});
  fetch(plan_footprints(all), coarse);
  for (int p = 0; p < fine_.local_count(); ++p)
    for (int d = 0; d < 3; ++d)
      interpolate_box(shadow_(p, d), fine(p, d), faces_of(fine_.local_box(p), d), d);
}

void CoarseFine::interpolate(const CellField<double>& coarse, CellField<double>& fine)
{
  std::vector<GhostPart> all;
  for (std::size_t f = 0; f < fine_.patches.size(); ++f)
    all.push_back({static_cast<int>(f), kCells, fine_.patches[f].box});
  plan_footprints(all).forward<double>([&](int p, int) -> const Array3<double>& { return coarse[p]; },
                                       [&](int p, int) -> Array3<double>& { return cells_[p]; });
  for (int p = 0; p < fine_.local_count(); ++p)
    interpolate_box(cells_[p], fine[p], fine_.local_box(p), kCells);
}

}  // namespace valsalva::ib3d
