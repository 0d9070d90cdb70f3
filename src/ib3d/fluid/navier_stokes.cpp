#include "ib3d/fluid/navier_stokes.hpp"

#include <cmath>

#include "ib3d/fluid/row_kernels.hpp"
#include "ib3d/grid/field_checkpoint.hpp"
#include "ib3d/grid/mirror.hpp"

namespace valsalva::ib3d {

namespace {

/// No penetration: the normal velocity on boundary faces without a prescribed pressure is zero.
void close_walls(const Level& level, const PressureGrid& grid, MacField& u)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (const SidePlane<float>& theta : grid.shares(p)) {
      const auto d = static_cast<std::size_t>(side_direction(theta.side));
      for (int b = theta.lo2; b < theta.lo2 + theta.n2; ++b)
        for (int a = theta.lo1; a < theta.lo1 + theta.n1; ++a) {
          if (theta(a, b) > 0) continue;
          Int3 at{};
          at[d] = side_is_high(theta.side) ? level.box.hi[d] : level.box.lo[d];
          at[static_cast<std::size_t>(theta.t1)] = a;
          at[static_cast<std::size_t>(theta.t2)] = b;
          u(p, static_cast<int>(d))(at[0], at[1], at[2]) = 0;
        }
    }
}

}  // namespace

NavierStokes::NavierStokes(const Level& level, std::vector<Opening> openings, const FluidParameters& fluid,
                           const PressureOptions& pressure)
    : level_(level),
      openings_(std::move(openings)),
      fluid_(fluid),
      solver_(level_, openings_, pressure),
      modes_(level_, openings_, solver_, fluid.density),
      faces_(Halo::for_faces(level_)),
      shared_faces_(Halo::for_faces(level_, 0)),
      u_(level_),
      u_new_(level_),
      rate_(level_),
      p_(level_),
      p_before_(level_),
      residual_(level_),
      p_b_(solver_.grid().zero_boundary_pressure())
{
}

void NavierStokes::fill_velocity_ghosts(MacField& u) const
{
  faces_.fill(u);
  fill_mirrored(level_, u);
}

void NavierStokes::set_velocity(const MacField& u)
{
  u_ = u;
  close_walls(level_, solver_.grid(), u_);
  fill_velocity_ghosts(u_);
  u_new_ = u_;
  dt_ = dt_before_ = 0;
}

void NavierStokes::begin_step(const MacField& f, double dt)
{
  dt_before_ = dt_;
  dt_ = dt;
  const double w1 = dt_before_ > 0 ? -0.5 * dt / dt_before_ : 0.0;
  advance_momentum(level_, fluid_, u_, f, dt, w1, rate_, u_new_);
  close_walls(level_, solver_.grid(), u_new_);
  shared_faces_.fill(u_new_);  // f is complete on owned faces only
}

void NavierStokes::prescribe(const std::vector<double>& opening_pressure)
{
  const std::vector<double> flow = flow_through(openings_, level_, u_);
  for (std::size_t m = 0; m < openings_.size(); ++m) {
    const Opening& o = openings_[m];
    const double inward = side_is_high(o.side) ? -1.0 : 1.0;
    const double mean = -flow[m] / disc_area(o, level_);
    const int k = side_is_high(o.side) ? level_.box.hi[2] : level_.box.lo[2];
    for (int p = 0; p < level_.local_count(); ++p)
      for (SidePlane<double>& plane : p_b_[static_cast<std::size_t>(p)]) {
        if (plane.side != o.side) continue;
        for (int b = plane.lo2; b < plane.lo2 + plane.n2; ++b)
          for (int a = plane.lo1; a < plane.lo1 + plane.n1; ++a) {
            if (!in_disc(o, level_, a, b)) continue;
            const double w = inward * u_(p, 2)(a, b, k);
            const double excess =
                fluid_.advection ? fluid_.density * (w * std::abs(w) - mean * std::abs(mean)) : 0.0;
            plane(a, b) = opening_pressure[m] - excess;
          }
      }
  }
}

/// residual = lap p - (rho/dt) div u*, with the ghosts of p filled.
void NavierStokes::pressure_residual()
{
  const double h2 = level_.h * level_.h;
  const double source = fluid_.density / (dt_ * level_.h);
  for (int p = 0; p < level_.local_count(); ++p) {
    const IndexBox& box = level_.local_box(p);
    const std::ptrdiff_t sy = p_[p].stride(1), sz = p_[p].stride(2);
    const std::ptrdiff_t fy = u_new_(p, 1).stride(1), fz = u_new_(p, 2).stride(2);
    for_each_row(box, [&](int j, int k) {
      const int i = box.lo[0];
      pressure_residual_row(residual_[p].at(i, j, k), p_[p].at(i, j, k), u_new_(p, 0).at(i, j, k),
                            u_new_(p, 1).at(i, j, k), u_new_(p, 2).at(i, j, k), 1 / h2, source, sy, sz, fy,
                            fz, box.size(0));
    });
  }
}

std::vector<double> NavierStokes::solve_pressure(const std::vector<double>& opening_pressure)
{
  // The guess 2 p^{n-1/2} - p^{n-3/2}, for steps of unequal length.
  const double ratio = dt_before_ > 0 ? dt_ / dt_before_ : 0.0;
  for (int q = 0; q < p_.patch_count(); ++q) {
    std::vector<double>& now = p_[q].data();
    std::vector<double>& before = p_before_[q].data();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double guess = now[i] + ratio * (now[i] - before[i]);
      before[i] = now[i];
      now[i] = guess;
    }
  }
  prescribe(opening_pressure);
  solver_.grid().fill_ghosts(p_, p_b_);
  pressure_residual();
  report_ = solver_.solve(residual_, p_, solver_.options().divergence_tolerance * fluid_.density / dt_);
  solver_.grid().fill_ghosts(p_, p_b_);

  std::vector<double> flow(openings_.size(), 0.0);
  for (std::size_t m = 0; m < openings_.size(); ++m) {
    const bool high = side_is_high(openings_[m].side);
    const int k = high ? level_.box.hi[2] : level_.box.lo[2];
    for (int p = 0; p < level_.local_count(); ++p) {
      const IndexBox& cells = level_.local_box(p);
      if (!level_.at_side(cells, openings_[m].side)) continue;
      for (int j = cells.lo[1]; j < cells.hi[1]; ++j)
        for (int i = cells.lo[0]; i < cells.hi[0]; ++i)
          if (in_disc(openings_[m], level_, i, j))
            flow[m] += u_new_(p, 2)(i, j, k) -
                       dt_ / (fluid_.density * level_.h) * (p_[p](i, j, k) - p_[p](i, j, k - 1));
    }
    flow[m] *= (high ? 1.0 : -1.0) * level_.h * level_.h;
  }
  MPI_Allreduce(MPI_IN_PLACE, flow.data(), static_cast<int>(flow.size()), MPI_DOUBLE, MPI_SUM, level_.comm);
  return flow;
}

void NavierStokes::finish_step(const std::vector<double>& phi)
{
  modes_.add(phi, p_);
  const double factor = dt_ / (fluid_.density * level_.h);
  for (int p = 0; p < level_.local_count(); ++p)
    for (int c = 0; c < 3; ++c) {
      const IndexBox box = faces_of(level_.local_box(p), c);
      const std::ptrdiff_t s = p_[p].stride(c);
      for_each_row(box, [&](int j, int k) {
        correct_row(u_new_(p, c).at(box.lo[0], j, k), p_[p].at(box.lo[0], j, k), factor, s, box.size(0));
      });
    }
  fill_velocity_ghosts(u_new_);
  std::swap(u_, u_new_);
}

void NavierStokes::save_or_restore(Checkpoint& c)
{
  c("fluid/dt", dt_);
  ib3d::save_or_restore(c, "fluid/u", level_, u_);
  ib3d::save_or_restore(c, "fluid/rate", level_, rate_);
  ib3d::save_or_restore(c, "fluid/p", level_, p_);
  ib3d::save_or_restore(c, "fluid/p_before", level_, p_before_);
  if (c.reading()) fill_velocity_ghosts(u_);
}

}  // namespace valsalva::ib3d
