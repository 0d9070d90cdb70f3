// Convective term div(u u) of the momentum equation in conservative form over the control volumes of the
// faces. For component c and direction d the flux through the low d-side of a control volume is
//     F = ubar q_up,   ubar = mean of the two nearest values of u_d,
// with q_up extrapolated from the upwind side: q_0 + s/2, the slope s = (a + 2 b)/3 of the upwind difference
// a and the downwind one b, limited to |s| <= 2 min(|a|, |b|) and to 0 at extrema (third order where smooth;
// Koren 1993). One pass per component: every flux is computed once, in rows along x. This is the one place
// with these loops.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Ghost layers that the fluxes read.
inline constexpr int kFluxGhosts = 2;

/// Fluxes through the low d-sides of n control volumes in a row. q: the component at the first one; sd: its
/// stride along d; v0, v1: the two advecting values of each side.
inline void flux_row(double* __restrict flux, const double* q, std::ptrdiff_t sd, const double* v0,
                     const double* v1, int n)
{
  for (int i = 0; i < n; ++i) {
    const double ubar = 0.5 * (v0[i] + v1[i]);
    const double below2 = q[i - 2 * sd], below = q[i - sd], above = q[i], above2 = q[i + sd];
    const bool forward = ubar > 0;
    const double q0 = forward ? below : above;
    const double a = forward ? below - below2 : above - above2;
    const double b = forward ? above - below : below - above;
    const double bound = 2 * std::min(std::abs(a), std::abs(b));
    const double slope = (a + 2 * b) * (1.0 / 3.0);
    const double limited = std::max(-bound, std::min(bound, slope));
    flux[i] = ubar * (q0 + 0.5 * (a * b > 0 ? limited : 0.0));
  }
}

/// Calls row(j, k, div) for every row of the faces `box` of component c, where div[0..n) is h div(u u)_c.
/// u: the three components of one patch, ghosts (2 layers) filled.
template <class Row>
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
    flux_row(flux, q.at(i, j, k), q.stride(d), d == c ? v - q.stride(d) : v - sc, v, count);
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

}  // namespace valsalva::ib3d
