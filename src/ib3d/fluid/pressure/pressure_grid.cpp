#include "ib3d/fluid/pressure/pressure_grid.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

bool no_pressure_anywhere(const Level& level, const std::vector<std::vector<SidePlane<float>>>& shares)
{
  int prescribed = 0;
  for (const auto& patch : shares)
    for (const auto& plane : patch)
      for (float theta : plane.value) prescribed = prescribed != 0 || theta > 0 ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &prescribed, 1, MPI_INT, MPI_MAX, level.comm);
  return prescribed == 0;
}

/// ghost = a x first value inside, along a line of n ghosts with distance `step`; `inward` leads inside.
template <class T>
inline void fill_line(T* ghost, const float* __restrict a, std::ptrdiff_t inward, std::ptrdiff_t step, int n)
{
  if (step == 1)
    for (int i = 0; i < n; ++i) ghost[i] = static_cast<T>(a[i]) * ghost[i + inward];
  else
    for (int i = 0; i < n; ++i) ghost[i * step] = static_cast<T>(a[i]) * ghost[i * step + inward];
}

/// ghost = (1 - 2 theta) p1 along one side, corner ghosts included.
template <class T>
void fill_side(const Level& level, const SidePlane<float>& reflection, Array3<T>& p)
{
  const Side side = reflection.side;
  const std::ptrdiff_t to_inside = inward(side) * p.stride(axis(side)), step = p.stride(first_tangent(side));
  reflection.for_each_row(p, level.box.cells_outside(side), [&](T* ghost, std::size_t first) {
    fill_line(ghost, &reflection.value[first], to_inside, step, reflection.n1);
  });
}

/// Adds 2 theta p_b on the cells' ghosts of one side.
void add_to_side(const Level& level, const SidePlane<float>& theta, const SidePlane<double>& p_b,
                 Array3<double>& p)
{
  const std::ptrdiff_t step = p.stride(first_tangent(theta.side));
  theta.for_each_row(p, level.box.cells_outside(theta.side), [&](double* ghost, std::size_t first) {
    for (int a = 0; a < theta.n1; ++a, ++first, ghost += step)
      *ghost += 2 * static_cast<double>(theta.value[first]) * p_b.value[first];
  });
}

/// 1 - 2 theta on the plane and one ring of corner ghosts around it, which repeat the nearest face.
std::vector<SidePlane<float>> reflections(const std::vector<SidePlane<float>>& shares)
{
  std::vector<SidePlane<float>> planes;
  for (const SidePlane<float>& theta : shares) {
    SidePlane<float> r = theta;
    r.lo1 -= 1;
    r.lo2 -= 1;
    r.n1 += 2;
    r.n2 += 2;
    r.value.resize(static_cast<std::size_t>(r.n1) * static_cast<std::size_t>(r.n2));
    r.for_each(0, [&](const Int3&, int a, int b) { r(a, b) = 1 - 2 * theta.clamped(a, b); });
    planes.push_back(std::move(r));
  }
  return planes;
}

}  // namespace

PressureGrid::PressureGrid(const Hierarchy& grid, int l, const std::vector<Opening>& openings)
    : level_(grid.level(l))
{
  for (int p = 0; p < level_.local_count(); ++p) {
    shares_.push_back(pressure_shares(grid, l, p, openings));
    reflections_.push_back(reflections(shares_.back()));
  }
  singular_ = no_pressure_anywhere(level_, shares_);
  halo_.push_back(Halo::for_cells(level_, 1));
}

PressureGrid PressureGrid::coarsened() const
{
  PressureGrid coarse;
  coarse.level_ = level_.coarsened();
  coarse.singular_ = singular_;
  coarse.halo_.push_back(Halo::for_cells(coarse.level_, 1));
  for (int p = 0; p < level_.local_count(); ++p) {
    coarse.shares_.emplace_back();
    for (const SidePlane<float>& fine : shares(p)) {
      SidePlane<float> plane(coarse.level_.local_box(p), fine.side, 0.0f);
      plane.for_each(0, [&](const Int3&, int a, int b) {
        plane(a, b) = coarse_share(fine(2 * a, 2 * b) + fine(2 * a + 1, 2 * b) + fine(2 * a, 2 * b + 1) +
                                   fine(2 * a + 1, 2 * b + 1));
      });
      coarse.shares_.back().push_back(std::move(plane));
    }
    coarse.reflections_.push_back(reflections(coarse.shares_.back()));
  }
  return coarse;
}

BoundaryPressure PressureGrid::zero_boundary_pressure() const
{
  BoundaryPressure zero;
  for (int p = 0; p < level_.local_count(); ++p) {
    zero.emplace_back();
    for (const SidePlane<float>& theta : shares(p))
      zero.back().emplace_back(level_.local_box(p), theta.side, 0.0);
  }
  return zero;
}

template <class T>
void PressureGrid::fill_ghosts(CellField<T>& p) const
{
  halo_[0].fill(p);
  for (int patch = 0; patch < p.patch_count(); ++patch)
    for (const SidePlane<float>& r : reflections_[static_cast<std::size_t>(patch)])
      fill_side(level_, r, p[patch]);
}
template void PressureGrid::fill_ghosts(CellField<double>&) const;
template void PressureGrid::fill_ghosts(CellField<float>&) const;

void PressureGrid::add_prescribed(CellField<double>& p, const BoundaryPressure& p_b) const
{
  for (int patch = 0; patch < p.patch_count(); ++patch)
    for (std::size_t s = 0; s < shares(patch).size(); ++s)
      add_to_side(level_, shares(patch)[s], p_b[static_cast<std::size_t>(patch)][s], p[patch]);
}

void set_boundary_pressure(std::vector<BoundaryPressure>& p_b, const OpeningFaces::Face& face, double value)
{
  const auto a = static_cast<std::size_t>(first_tangent(face.side)),
             b = static_cast<std::size_t>(second_tangent(face.side));
  for (SidePlane<double>& plane :
       p_b[static_cast<std::size_t>(face.level)][static_cast<std::size_t>(face.patch)])
    if (plane.side == face.side) plane(face.at[a], face.at[b]) = value;
}

}  // namespace valsalva::ib3d
