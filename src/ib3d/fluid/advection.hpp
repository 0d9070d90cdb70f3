// Convective term div(u u) of the momentum equation in conservative form over the control volumes of the
// faces. For component c and direction d the flux through the low d-side of a control volume is
//     F = ubar q_up,   ubar = mean of the two nearest values of u_d,
// with q_up, the value of component c on that side, from the upwind side (upwind.hpp). One pass per component: every
// flux is computed once, in rows along x. This is the one place with these loops.
#pragma once

#include <vector>

#include "ib3d/fluid/upwind.hpp"
#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

// The long arithmetic of xsppm7 gains a sixth from the full width of AVX-512, which GCC does not use by itself.
#ifdef __AVX512F__
#define VALSALVA_FULL_WIDTH [[gnu::noinline, gnu::target("prefer-vector-width=512")]]
#else
#define VALSALVA_FULL_WIDTH
#endif

/// Fluxes through the low d-sides of n control volumes in a row. q: the component at the first one; sd: its
/// stride along d; v0, v1: the two advecting values of each side.
template <auto upwind_value>
VALSALVA_FULL_WIDTH inline void flux_row(double* __restrict flux, const double* q, std::ptrdiff_t sd,
                                         const double* v0, const double* v1, int n)
{
  for (int i = 0; i < n; ++i) {
    const double ubar = 0.5 * (v0[i] + v1[i]);
    flux[i] = ubar * upwind_value(q + i, sd, ubar > 0);
  }
}

/// Calls row(j, k, div) for every row of the faces `box` of component c, where div[0..n) is h div(u u)_c.
/// u: the three components of one patch, ghosts filled (kMacGhosts layers; 2 for the limited flux).
template <auto upwind_value, class Row>
void for_each_convected_row(const std::array<const Array3<double>*, 3>& u, int c, const IndexBox& box,
                            Row&& row)
{
  const int n = box.size(0);
  const std::size_t width = static_cast<std::size_t>(n);
  const Array3<double>& q = *u[static_cast<std::size_t>(c)];
  const std::ptrdiff_t sc = q.stride(c);
  std::vector<double> plane(width * static_cast<std::size_t>(box.size(1)));  // fluxes through the low z sides
  std::vector<double> fx(width + 1), fy(width), fy_next(width), fz_next(width), div(width);

  const auto fluxes = [&](double* flux, int d, int i, int j, int k, int count) {
    const double* v = u[static_cast<std::size_t>(d)]->at(i, j, k);
    flux_row<upwind_value>(flux, q.at(i, j, k), q.stride(d), d == c ? v - q.stride(d) : v - sc, v, count);
  };
  for (int j = box.lo[1]; j < box.hi[1]; ++j)
    fluxes(plane.data() + width * static_cast<std::size_t>(j - box.lo[1]), 2, box.lo[0], j, box.lo[2], n);
  for (int k = box.lo[2]; k < box.hi[2]; ++k) {
    fluxes(fy.data(), 1, box.lo[0], box.lo[1], k, n);
    for (int j = box.lo[1]; j < box.hi[1]; ++j) {
      double* fz = plane.data() + width * static_cast<std::size_t>(j - box.lo[1]);
      fluxes(fx.data(), 0, box.lo[0], j, k, n + 1);
      fluxes(fy_next.data(), 1, box.lo[0], j + 1, k, n);
      fluxes(fz_next.data(), 2, box.lo[0], j, k + 1, n);
      for (std::size_t i = 0; i < width; ++i)
        div[i] = (fx[i + 1] - fx[i]) + (fy_next[i] - fy[i]) + (fz_next[i] - fz[i]);
      row(j, k, div.data());
      std::swap(fy, fy_next);
      std::copy(fz_next.begin(), fz_next.end(), fz);
    }
  }
}

/// The same with the flux chosen by name; without one, div is zero.
template <class Row>
void for_each_convected_row(Advection scheme, const std::array<const Array3<double>*, 3>& u, int c,
                            const IndexBox& box, Row&& row)
{
  switch (scheme) {
    case Advection::xsppm7:
      return for_each_convected_row<xsppm7_upwind>(u, c, box, row);
    case Advection::limited:
      return for_each_convected_row<limited_upwind>(u, c, box, row);
    case Advection::none:
      break;
  }
  const std::vector<double> zero(static_cast<std::size_t>(box.size(0)), 0.0);
  for_each_row(box, [&](int j, int k) { row(j, k, zero.data()); });
}

#undef VALSALVA_FULL_WIDTH

}  // namespace valsalva::ib3d
