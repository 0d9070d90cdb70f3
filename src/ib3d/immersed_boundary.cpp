#include "ib3d/immersed_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"
#include "ib3d/fluid/vorticity.hpp"
#include "ib3d/grid/field_checkpoint.hpp"
#include "ib3d/grid/row_kernels.hpp"
#include "ib3d/structure/fibres/fibre_force.hpp"
#include "ib3d/structure/fibres/fold_relaxation.hpp"

namespace valsalva::ib3d {

namespace {

constexpr int kStepsBetweenElasticSweeps = 30;
constexpr int kStepsOfOneConvection = 8;

/// x += dt u for n values; returns the largest |u|, infinity for NaN.
double move(double* __restrict x, const double* __restrict u, double dt, std::ptrdiff_t n)
{
  double fastest = 0, sum = 0;
#pragma omp simd reduction(max : fastest) reduction(+ : sum)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    x[i] += dt * u[i];
    fastest = std::max(fastest, std::abs(u[i]));
    sum += std::abs(u[i]);
  }
  return largest_or_infinity(fastest, sum);
}

}  // namespace

ImmersedBoundarySolver::ImmersedBoundarySolver(const Hierarchy& grid, std::vector<Opening> openings,
                                               const FluidParameters& fluid, const PressureOptions& pressure,
                                               FibreNetwork structure, StructureScheme scheme, Timers& timers,
                                               RefinementPolicy refinement, std::vector<MarkerSeed> seeds,
                                               double fold_relaxation)
    : scheme_(scheme),
      fold_relaxation_(fold_relaxation),
      timers_(timers),
      policy_(std::move(refinement)),
      fluid_(std::make_unique<NavierStokes>(grid, std::move(openings), fluid, pressure)),
      nodes_(std::move(structure), grid.finest()),
      interaction_(grid.finest()),
      elastic_(grid.finest(), fluid.density),
      markers_(std::move(seeds)),
      f_(grid.finest()),
      X_(nodes_.part().network.X),
      X_of_cuts_(nodes_.whole().X),
      X_of_grid_(nodes_.whole().X)
{
}

void ImmersedBoundarySolver::begin_step(double dt)
{
  dt_ = dt;
  const auto count = X_.size();
  U_.resize(count);
  F_.resize(count);
  const std::vector<Vec3>* forced_at = &X_;
  if (scheme_ == StructureScheme::midpoint) {
    const auto scope = timers_.time("interpolate");
    interaction_.interpolate(nodes_.first(), X_, fluid_->u().back(), U_);
    add_slip(X_);
    X_middle_.resize(count);
    for (std::size_t n = 0; n < count; ++n) X_middle_[n] = X_[n] + 0.5 * dt * U_[n];
    nodes_.fill_copies(X_middle_);
    forced_at = &X_middle_;
  }
  {
    const auto scope = timers_.time("fibre force");
    fibre_force(nodes_.part().network, *forced_at, F_);
  }
  {
    const auto scope = timers_.time("spread");
    interaction_.spread(nodes_.first(), *forced_at, F_, f_);
  }
  const auto scope = timers_.time("momentum");
  fluid_->begin_step(f_, dt, keep_convection(dt));
}

bool ImmersedBoundarySolver::keep_convection(double dt)
{
  // viscosity has its share of the same stretch of stability (scheme 5.1)
  const double viscous = viscous_step_limit(fluid_->grid().finest(), fluid_->fluid());
  const double cfl = dt * (courant_rate_ + 0.5 / viscous);
  const bool keep = steps_since_convection_ < kStepsOfOneConvection &&
                    cfl_since_convection_ + cfl <= fluid_->fluid().convection_cfl;
  steps_since_convection_ = keep ? steps_since_convection_ + 1 : 1;
  cfl_since_convection_ = keep ? cfl_since_convection_ + cfl : cfl;
  return keep;
}

std::vector<double> ImmersedBoundarySolver::solve_fluid(const std::vector<double>& opening_pressure)
{
  const auto scope = timers_.time("projection");
  return fluid_->solve_pressure(opening_pressure);
}

void ImmersedBoundarySolver::accept(const std::vector<double>& phi)
{
  double fastest = 0;
  {
    const auto scope = timers_.time("projection");
    fluid_->finish_step(phi);
  }
  {
    const auto scope = timers_.time("interpolate");
    if (scheme_ == StructureScheme::midpoint) {
      U_before_.resize(U_.size());
      interaction_.interpolate(nodes_.first(), X_middle_, fluid_->u_before().back(), U_before_);
      interaction_.interpolate(nodes_.first(), X_middle_, fluid_->u().back(), U_);
      for (std::size_t n = 0; n < U_.size(); ++n) U_[n] = 0.5 * (U_[n] + U_before_[n]);
      add_slip(X_middle_);
    } else {
      interaction_.interpolate(nodes_.first(), X_, fluid_->u().back(), U_);
      add_slip(X_);
    }
    if (nodes_.owned() > 0) fastest = move(&X_[0][0], &U_[0][0], dt_, 3 * nodes_.owned());
    nodes_.fill_copies(X_);
  }
  if (markers_.wanted()) {
    const auto scope = timers_.time("markers");
    markers_.advance(fluid_->grid(), fluid_->u(), dt_);
  }
  const auto scope = timers_.time("step control");
  check_and_redistribute(dt_ * fastest / fluid_->grid().finest().h);
}

void ImmersedBoundarySolver::add_slip(const std::vector<Vec3>& X)
{
  // Steps longer than the time would overshoot.
  if (fold_relaxation_ > 0) add_fold_slip(nodes_.part().network, X, std::max(fold_relaxation_, dt_), U_);
}

void ImmersedBoundarySolver::check_and_redistribute(double moved_cells)
{
  room_cells_ -= moved_cells;
  if (room_cells_ <= 0) room_cells_ = kNodeDrift - nodes_.farthest_out(X_);
  double state[3] = {fluid_->courant_rate(), room_cells_ <= 0 ? 1.0 : 0.0, moved_cells};
  MPI_Allreduce(MPI_IN_PLACE, state, 3, MPI_DOUBLE, MPI_MAX, fluid_->grid().comm());
  courant_rate_ = state[0];
  if (!std::isfinite(courant_rate_)) return;  // the step has blown up: CoupledModel says so
  moved_cells_ += policy_.vorticity > 0 ? std::max(state[2], dt_ * courant_rate_) : state[2];
  // What is not finite is for `redistribute` to refuse.
  if (policy_.levels > 1 && moved_cells_ > policy_.margin_cells - 0.5 && std::isfinite(moved_cells_))
    regrid_if_moved();
  if (state[1] == 0) return;
  X_ = nodes_.redistribute(X_);
  room_cells_ = 0;
  elastic_.restart();
}

void ImmersedBoundarySolver::regrid_if_moved()
{
  const std::vector<Vec3> X = nodes_.gather(X_);
  const Hierarchy& grid = fluid_->grid();
  if (policy_.vorticity == 0) {  // what the nodes have really moved
    double furthest = 0;
    for (std::size_t n = 0; n < X.size(); ++n)
      for (int d = 0; d < 3; ++d) furthest = max_or_nan(furthest, std::abs(X[n][d] - X_of_grid_[n][d]));
    moved_cells_ = furthest / grid.finest().h;
    if (moved_cells_ < policy_.margin_cells - 1) return;
  }
  std::vector<RefinedRegion> vortical;
  if (policy_.vorticity > 0) vortical = vortical_blocks(grid, fluid_->u(), policy_.vorticity);
  const Refinement boxes = refine(grid.domain(), grid.finest().h, policy_, X, vortical);
  moved_cells_ = 0;
  if (boxes == grid.refinement())
    X_of_grid_ = X;  // the same grid serves
  else
    rebuild(boxes, X);
}

void ImmersedBoundarySolver::rebuild(const Refinement& boxes, const std::vector<Vec3>& X)
{
  const Hierarchy before = fluid_->grid();
  const Hierarchy grid(before.domain(), before.finest().h, before.comm(), boxes, X);
  fluid_ = std::make_unique<NavierStokes>(grid, *fluid_);
  nodes_.move_to(grid.finest(), X);
  room_cells_ = 0;
  interaction_ = Interaction(grid.finest());
  elastic_ = ElasticBound(grid.finest(), fluid_->fluid().density);
  steps_since_elastic_ = 0;
  f_ = MacField(grid.finest());
  X_ = nodes_.part().network.X;
  X_of_cuts_ = X_of_grid_ = X;
  markers_.settle(grid);
}

double ImmersedBoundarySolver::elastic_rate()
{
  const auto scope = timers_.time("step control");
  if (steps_since_elastic_++ % kStepsBetweenElasticSweeps == 0) elastic_.update(nodes_, interaction_, X_, 1);
  return elastic_.omega();
}

double ImmersedBoundarySolver::elastic_energy() const
{
  return fibre_energy(nodes_.whole(), nodes_.gather(X_));
}

void ImmersedBoundarySolver::save_or_restore(Checkpoint& c)
{
  std::vector<Vec3> X = X_of_cuts_;
  Refinement boxes = fluid_->grid().refinement();
  c("grid/cut_for_X", X);
  if (X.size() != X_of_cuts_.size())
    throw IoError(fmt::format("{}: {} nodes, but the case builds {}", c.path(), X.size(), X_of_cuts_.size()));
  ib3d::save_or_restore(c, "grid", boxes);
  const bool as_built = std::memcmp(X.data(), X_of_cuts_.data(), X.size() * sizeof(Vec3)) == 0;
  if (c.reading() && (!as_built || boxes != fluid_->grid().refinement())) rebuild(boxes, X);
  c("grid/fits_X", X_of_grid_);
  c("grid/moved_cells", moved_cells_);
  fluid_->save_or_restore(c);
  nodes_.save_or_restore(c);
  nodes_.save_or_restore(c, "structure/X", X_);
  if (c.reading()) room_cells_ = 0;
  if (c.reading()) check_and_redistribute(0);  // other ranks may have other patches
  elastic_.save_or_restore(c, nodes_);
  c("structure/steps_since_elastic", steps_since_elastic_);
  c("fluid/steps_since_convection", steps_since_convection_);
  c("fluid/cfl_since_convection", cfl_since_convection_);
  markers_.save_or_restore(c, fluid_->grid());
}

}  // namespace valsalva::ib3d
