#include "ib3d/grid/coarse_fine.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

constexpr int kShadowGhosts = kMacGhosts / 2 + 2;

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

/// Coarse values that fine values read.
IndexBox footprint(const IndexBox& fine, Centring c)
{
  IndexBox b;
  for (int d = 0; d < 3; ++d) {
    const auto dd = static_cast<std::size_t>(d);
    b.lo[dd] = half_below(fine.lo[dd]) - 1;
    b.hi[dd] = half_below(fine.hi[dd] - 1) + (is_normal(c, d) ? 3 : 2);
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
void interpolate_box(const Array3<double>& coarse, Array3<double>& fine, const IndexBox& box,
                     Centring centring)
{
  const IndexBox from = footprint(box, centring);
  const int n = from.size(0), rows = from.size(1);
  std::vector<double> plane(static_cast<std::size_t>(n) * static_cast<std::size_t>(rows)),
      row(static_cast<std::size_t>(n));
  for (int k = box.lo[2]; k < box.hi[2]; ++k) {
    const Taps z = taps_of(centring == Centring::z_face, k);
    for (int j = 0; j < rows; ++j)
      mix_rows(plane.data() + static_cast<std::ptrdiff_t>(j) * n,
               coarse.at(from.lo[0], from.lo[1] + j, z.first), coarse.stride(2), z, n);
    for (int j = box.lo[1]; j < box.hi[1]; ++j) {
      const Taps y = taps_of(centring == Centring::y_face, j);
      mix_rows(row.data(), plane.data() + static_cast<std::ptrdiff_t>(y.first - from.lo[1]) * n, n, y, n);
      expand_row(fine.at(box.lo[0], j, k), row.data() - from.lo[0], centring == Centring::x_face, box.lo[0],
                 box.hi[0]);
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
  return {cells.with_range(d, cells.lo[dd], 1), cells.with_range(d, cells.hi[dd], 1)};
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
  for_each_overlap(coarsened_, coarse_, [&](std::size_t f, std::size_t c, const Int3& shift) {
    const Patch &from = coarsened_.patches[f], &to = coarse_.patches[c];
    for (int d = 0; d < 3; ++d) {
      const Centring face = face_normal_to(d);
      down_faces_.add(from, to, shift, face, faces_of(from.box, d), faces_of(to.box, d));
      for (const IndexBox& side : end_planes(from.box, d))
        down_edges_.add(from, to, shift, face, side, faces_of(to.box, d));
    }
    down_cells_.add(from, to, shift, Centring::cell, from.box, to.box);
    const IndexBox common = intersect(from.box.shifted(shift), to.box);
    if (to.local >= 0 && !common.empty()) covered_[static_cast<std::size_t>(to.local)].push_back(common);
  });

  IndexBox inside = fine_.box;  // in periodic directions everything is inside
  for (const Side side : kSides)
    if (fine_.domain.periodic(axis(side))) inside = inside.extended(side, ghosts);
  for (const Patch& patch : fine_.patches)
    for (int d = 0; d < 3; ++d)
      for (const IndexBox& faces :
           uncovered({intersect(faces_of(patch.box.grown(ghosts), d), faces_of(inside, d))}, fine_,
                     face_normal_to(d))) {
        plan_footprint(up_ghosts_, patch, face_normal_to(d), faces);
        if (patch.local >= 0) ghosts_.push_back({patch.local, face_normal_to(d), faces});
      }
}

/// Values of a patch may be read where they are its own or beyond the sides of the domain.
void CoarseFine::plan_footprint(CopyPlan& plan, const Patch& to, Centring c, const IndexBox& values) const
{
  const int outside = c == Centring::cell ? 1 : kMacGhosts;
  plan.add_sources(coarse_, to, c, footprint(values, c), [&](const IndexBox& cells) {
    return coarse_.with_outside(cells, indices_of(cells, c), outside);
  });
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

void CoarseFine::average_down(const MacField& fine, MacField& coarse)
{
  for (int p = 0; p < fine_.local_count(); ++p)
    for (int d = 0; d < 3; ++d) average(fine, p, d, faces_of(coarsened_.local_box(p), d));
  down_faces_.forward(shadow_, coarse);
}

void CoarseFine::average_down_edges(const MacField& fine, MacField& coarse)
{
  for (int p = 0; p < fine_.local_count(); ++p)
    for (int d = 0; d < 3; ++d)
      for (const IndexBox& side : end_planes(coarsened_.local_box(p), d)) average(fine, p, d, side);
  down_edges_.forward(shadow_, coarse);
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
  down_cells_.forward(means, coarse);
}
template void CoarseFine::average_down(const CellField<float>&, CellField<float>&);
template void CoarseFine::average_down(const CellField<double>&, CellField<double>&);

void CoarseFine::fill_ghosts(const MacField& coarse, MacField& fine)
{
  up_ghosts_.forward(coarse, shadow_);
  for (const GhostPart& g : ghosts_)
    interpolate_box(shadow_(g.patch, g.centring), fine(g.patch, g.centring), g.faces, g.centring);
}

void CoarseFine::interpolate(const MacField& coarse, MacField& fine)
{
  interpolate(coarse, shadow_, fine, {Centring::x_face, Centring::y_face, Centring::z_face});
}

void CoarseFine::interpolate(const CellField<double>& coarse, CellField<double>& fine)
{
  interpolate(coarse, cells_, fine, {Centring::cell});
}

template <class Field>
void CoarseFine::interpolate(const Field& coarse, Field& shadow, Field& fine,
                             const std::vector<Centring>& centrings) const
{
  CopyPlan plan(coarse_.comm);
  for (const Patch& patch : fine_.patches)
    for (const Centring c : centrings) plan_footprint(plan, patch, c, indices_of(patch.box, c));
  plan.forward(coarse, shadow);
  for (int p = 0; p < fine_.local_count(); ++p)
    for (const Centring c : centrings)
      interpolate_box(shadow(p, c), fine(p, c), indices_of(fine_.local_box(p), c), c);
}

}  // namespace valsalva::ib3d
