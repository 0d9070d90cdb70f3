#include "ib3d/grid/regrid.hpp"

#include <bit>

namespace valsalva::ib3d {

Regrid::Regrid(const Hierarchy& before, const Hierarchy& after, std::vector<CoarseFine>& transfers)
    : before_(before), after_(after), transfers_(transfers)
{
  for (int l = 0; l < std::min(before.level_count(), after.level_count()); ++l) {
    const Level &from = before.level(l), &to = after.level(l);
    CopyPlan &faces = faces_.emplace_back(after.comm()), &cells = cells_.emplace_back(after.comm());
    for_each_overlap(from, to, [&](std::size_t a, std::size_t b, const Int3& shift) {
      const auto add = [&](CopyPlan& plan, Centring c) {
        const Patch &there = from.patches[a], &here = to.patches[b];
        plan.add(there, here, shift, c, indices_of(there.box, c), indices_of(here.box, c));
      };
      for (int d = 0; d < 3; ++d) add(faces, face_normal_to(d));
      add(cells, Centring::cell);
    });
  }
}

void Regrid::carry(int l, const CompositeMac& before, CompositeMac& after, bool keep_divergence) const
{
  const auto ll = static_cast<std::size_t>(l);
  if (l > 0) transfers_[ll - 1].interpolate(after[ll - 1], after[ll]);
  if (ll < faces_.size()) faces_[ll].forward(before[ll], after[ll]);
  if (l == 0 || !keep_divergence) return;
  const Level& level = after_.level(l);
  for (int p = 0; p < level.local_count(); ++p) {
    std::vector<IndexBox> fresh{level.local_box(p)};
    if (l < before_.level_count()) fresh = uncovered(fresh, before_.level(l));
    for (const IndexBox& box : fresh)
      even_out_divergence(box.coarsened(), {&after[ll](p, 0), &after[ll](p, 1), &after[ll](p, 2)});
  }
}

void Regrid::carry(int l, const CompositeCells<double>& before, CompositeCells<double>& after) const
{
  const auto ll = static_cast<std::size_t>(l);
  if (l > 0) transfers_[ll - 1].interpolate(after[ll - 1], after[ll]);
  if (ll < cells_.size()) cells_[ll].forward(before[ll], after[ll]);
}

void even_out_divergence(const IndexBox& coarse_cells, const std::array<Array3<double>*, 3>& u)
{
  for_each_index(coarse_cells, [&](int ci, int cj, int ck) {
    const auto cell = [&](unsigned s) {
      return Int3{2 * ci + static_cast<int>(s & 1), 2 * cj + static_cast<int>((s >> 1) & 1),
                  2 * ck + static_cast<int>(s >> 2)};
    };
    double divergence[8];
    for (unsigned s = 0; s < 8; ++s) {
      const Int3 c = cell(s);
      divergence[s] = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        Int3 above = c;
        ++above[d];
        divergence[s] += (*u[d])(above[0], above[1], above[2]) - (*u[d])(c[0], c[1], c[2]);
      }
    }
    // lap phi = divergence on the corners of a cube, which Walsh functions diagonalise: eigenvalue -2 x bits of m.
    double phi[8] = {};
    for (unsigned m = 1; m < 8; ++m) {
      double amplitude = 0;
      for (unsigned s = 0; s < 8; ++s)
        amplitude += std::popcount(m & s) % 2 == 0 ? divergence[s] : -divergence[s];
      amplitude /= -16.0 * std::popcount(m);
      for (unsigned s = 0; s < 8; ++s) phi[s] += std::popcount(m & s) % 2 == 0 ? amplitude : -amplitude;
    }
    for (std::size_t d = 0; d < 3; ++d)
      for (unsigned s = 0; s < 8; ++s) {
        if (((s >> d) & 1) == 0) continue;
        const Int3 c = cell(s);
        (*u[d])(c[0], c[1], c[2]) -= phi[s] - phi[s ^ (1u << d)];
      }
  });
}

}  // namespace valsalva::ib3d
