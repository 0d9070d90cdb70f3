#include "ib3d/fluid/navier_stokes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ib3d/fluid/advection.hpp"
#include "ib3d/fluid/courant_rate.hpp"
#include "ib3d/fluid/velocity_correction.hpp"
#include "ib3d/grid/field_checkpoint.hpp"
#include "ib3d/grid/mirror.hpp"
#include "ib3d/grid/regrid.hpp"
#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

/// No penetration: the normal velocity on boundary faces without a prescribed pressure is zero.
void close_walls(const PressureGrid& grid, MacField& u)
{
  const Level& level = grid.level();
  for (int p = 0; p < level.local_count(); ++p)
    for (const SidePlane<float>& theta : grid.shares(p)) {
      Array3<double>& normal = u(p, axis(theta.side));
      const std::ptrdiff_t step = normal.stride(first_tangent(theta.side));
      theta.for_each_row(normal, level.box.faces_at(theta.side), [&](double* face, std::size_t first) {
        for (int a = 0; a < theta.n1; ++a, ++first, face += step)
          if (theta.value[first] == 0) *face = 0;
      });
    }
}

}  // namespace

NavierStokes::NavierStokes(const Hierarchy& grid, std::vector<Opening> openings, const FluidParameters& fluid,
                           const PressureOptions& pressure)
    : grid_(grid),
      openings_(std::move(openings)),
      fluid_(fluid),
      transfers_(transfers_between_levels(grid_, ghosts_read(fluid_.advection))),
      opening_faces_(grid_, openings_),
      solver_(grid_, openings_, pressure, transfers_),
      modes_(opening_faces_, solver_, fluid.density),
      u_(composite_faces(grid_)),
      u_new_(composite_faces(grid_)),
      rates_{composite_faces(grid_), composite_faces(grid_)},
      p_(composite_cells<double>(grid_)),
      p_before_(composite_cells<double>(grid_)),
      p_new_(composite_cells<double>(grid_)),
      p_b_(solver_.problem().zero_boundary_pressure())
{
  if (fluid.viscosity_scheme == ViscosityScheme::crank_nicolson) viscous_.emplace(grid_);
  for (const Level& level : grid_.levels()) {
    faces_.push_back(Halo::for_faces(level, std::max(ghosts_read(fluid.advection), kNodeGhosts)));
    shared_faces_.push_back(Halo::for_faces(level, 0));
  }
}

NavierStokes::NavierStokes(const Hierarchy& grid, const NavierStokes& before)
    : NavierStokes(grid, before.openings_, before.fluid_, before.solver_.options())
{
  const Regrid regrid(before.grid_, grid_, transfers_);
  for (int l = 0; l < grid_.level_count(); ++l) {
    const auto ll = static_cast<std::size_t>(l);
    regrid.carry(l, before.u_, u_, true);
    regrid.carry(l, before.rates_.last, rates_.last, false);
    regrid.carry(l, before.rates_.before, rates_.before, false);
    fill_velocity_ghosts(ll, u_);
    fill_velocity_ghosts(ll, rates_.last);
    fill_velocity_ghosts(ll, rates_.before);
    regrid.carry(l, before.p_, p_);
    regrid.carry(l, before.p_before_, p_before_);
    solver_.problem().grid(l).fill_ghosts(p_[ll]);
    solver_.problem().grid(l).fill_ghosts(p_before_[ll]);
  }
  u_new_ = u_;
  rates_.age = before.rates_.age;
  rates_.gap = before.rates_.gap;
  report_ = before.report_;
  dt_ = before.dt_;
  dt_before_ = before.dt_before_;
}

void NavierStokes::average_down(CompositeMac& u)
{
  for (std::size_t l = u.size() - 1; l > 0; --l) transfers_[l - 1].average_down(u[l], u[l - 1]);
}

void NavierStokes::fill_velocity_ghosts(std::size_t l, CompositeMac& u)
{
  if (l > 0) transfers_[l - 1].fill_ghosts(u[l - 1], u[l]);
  faces_[l].fill(u[l]);
  fill_mirrored(grid_.levels()[l], u[l], ghosts_read(fluid_.advection));
}

void NavierStokes::fill_velocity_ghosts(CompositeMac& u)
{
  for (std::size_t l = 0; l < u.size(); ++l) fill_velocity_ghosts(l, u);
}

void NavierStokes::complete(CompositeMac& u)
{
  for (int l = 0; l < grid_.level_count(); ++l)
    close_walls(solver_.problem().grid(l), u[static_cast<std::size_t>(l)]);
  average_down(u);
  fill_velocity_ghosts(u);
}

void NavierStokes::set_velocity(const CompositeMac& u)
{
  u_ = u;
  complete(u_);
  u_new_ = u_;
  dt_ = dt_before_ = 0;
  rates_.age = rates_.gap = 0;
  rates_.of_now = false;
  finest_rate_.reset();
}

double NavierStokes::courant_rate() const
{
  double largest = finest_rate_ ? *finest_rate_ : ib3d::courant_rate(grid_.finest(), u_.back());
  for (std::size_t l = 0; l + 1 < u_.size(); ++l)
    largest = std::max(largest, ib3d::courant_rate(grid_.levels()[l], u_[l]));
  return largest;
}

std::vector<double> NavierStokes::kinetic_outflow() const
{
  return opening_faces_.flow_of([&](const OpeningFaces::Face& f) {
    const double w = f.normal(u_);
    return 0.5 * fluid_.density * w * w * w;
  });
}

void NavierStokes::begin_step(const MacField& f, double dt, bool keep_rates)
{
  std::vector<const MacField*> force(u_.size(), nullptr);
  force.back() = &f;
  compute_u_star(force, dt, keep_rates);
}

void NavierStokes::begin_step(const CompositeMac& f, double dt, bool keep_rates)
{
  std::vector<const MacField*> force;
  for (const MacField& level : f) force.push_back(&level);
  compute_u_star(force, dt, keep_rates);
}

void NavierStokes::compute_u_star(const std::vector<const MacField*>& f, double dt, bool keep_rates)
{
  dt_ = dt;
  const bool keep = keep_rates && rates_.known();
  if (!keep) rates_.renew();
  const double w1 = rates_.weight_before(dt);
  for (std::size_t l = 0; l < u_.size(); ++l) {
    const Level& level = grid_.levels()[l];
    if (keep)
      advance_momentum_kept(level, fluid_, u_[l], f[l], dt, w1, rates_.last[l], rates_.before[l], u_new_[l]);
    else
      advance_momentum(level, fluid_, u_[l], f[l], dt, w1, rates_.last[l], rates_.before[l], u_new_[l]);
    close_walls(solver_.problem().grid(static_cast<int>(l)), u_new_[l]);
    shared_faces_[l].fill(u_new_[l]);  // f is complete on owned faces only
  }
  for (std::size_t l = u_new_.size() - 1; l > 0; --l)
    transfers_[l - 1].average_down_edges(u_new_[l], u_new_[l - 1]);
}

void NavierStokes::prescribe(const std::vector<double>& opening_pressure)
{
  const std::vector<double> flow = opening_faces_.flow(u_);
  const bool convected = fluid_.advection != Advection::none;
  for (std::size_t m = 0; m < openings_.size(); ++m) {
    const double mean = -flow[m] / opening_faces_.area(m);
    for (const OpeningFaces::Face& f : opening_faces_.of(m)) {
      const double w = inward(f.side) * f.normal(u_);
      const double excess = convected ? fluid_.density * (w * std::abs(w) - mean * std::abs(mean)) : 0.0;
      set_boundary_pressure(p_b_, f, opening_pressure[m] - excess);
    }
  }
}

/// (2.7): the gradient of the guessed pressure takes part in the solve, so that the walls' condition on u* holds for
/// u^{n+1} to second order; it is taken out again for the projection to put in the whole.
void NavierStokes::diffuse()
{
  solver_.problem().fill_ghosts(p_new_, p_b_);
  subtract_gradient(dt_);
  const double diffusion = 0.5 * dt_ * fluid_.viscosity / fluid_.density;
  viscous_sweeps_ = viscous_->solve(diffusion, u_, u_new_, [this](CompositeMac& v) { complete(v); });
  subtract_gradient(-dt_);
  average_down(u_new_);
}

std::vector<double> NavierStokes::solve_pressure(const std::vector<double>& opening_pressure)
{
  // The guess 2 p^{n-1/2} - p^{n-3/2}, for steps of unequal length.
  const double ratio = dt_before_ > 0 ? dt_ / dt_before_ : 0.0;
  for (std::size_t l = 0; l < p_.size(); ++l)
    for (int q = 0; q < p_[l].patch_count(); ++q)
      extrapolate_row(p_new_[l][q].data().data(), p_[l][q].data().data(), p_before_[l][q].data().data(),
                      ratio, p_[l][q].data().size());
  prescribe(opening_pressure);
  if (viscous_) diffuse();
  const double source = fluid_.density / dt_;
  report_ = solver_.solve(p_new_, p_b_, &u_new_, source, solver_.options().divergence_tolerance * source,
                          solver_.options().max_iterations);
  return opening_faces_.flow_of([&](const OpeningFaces::Face& f) {
    return f.normal(u_new_) - dt_ / (fluid_.density * grid_.level(f.level).h) * f.jump(p_new_);
  });
}

void NavierStokes::finish_step(const std::vector<double>& phi)
{
  finest_rate_ = correct_velocity(grid_, modes_, phi, dt_ / fluid_.density, p_new_, u_new_);
  average_down(u_new_);
  fill_velocity_ghosts(u_new_);
  std::swap(u_, u_new_);
  std::swap(p_, p_before_);
  std::swap(p_, p_new_);
  rates_.accept(dt_);
  dt_before_ = dt_;
}

void NavierStokes::subtract_gradient(double dt)
{
  for (std::size_t l = 0; l < u_.size(); ++l)
    ib3d::subtract_gradient(grid_.levels()[l], dt / fluid_.density, p_new_[l], u_new_[l]);
}

void NavierStokes::save_or_restore(Checkpoint& c)
{
  c("fluid/dt", dt_);
  c("fluid/rates_age", rates_.age);
  c("fluid/rates_gap", rates_.gap);
  for (std::size_t l = 0; l < u_.size(); ++l) {
    const std::string name = fmt::format("fluid/level_{}/", l);
    const Level& level = grid_.levels()[l];
    ib3d::save_or_restore(c, name + "u", level, u_[l]);
    ib3d::save_or_restore(c, name + "rate", level, rates_.last[l]);
    ib3d::save_or_restore(c, name + "rate_before", level, rates_.before[l]);
    ib3d::save_or_restore(c, name + "p", level, p_[l]);
    ib3d::save_or_restore(c, name + "p_before", level, p_before_[l]);
  }
  if (!c.reading()) return;
  dt_before_ = dt_;
  rates_.of_now = false;
  fill_velocity_ghosts(u_);
  finest_rate_.reset();
}

}  // namespace valsalva::ib3d
