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

namespace valsalva::ib3d {

namespace {

constexpr int kStepsBetweenElasticSweeps = 30;
constexpr int kStepsOfOneConvection = 8;

/// Moves the first `count` nodes, X += dt U; returns the largest velocity along any direction, infinity for NaN.
double move(std::vector<Vec3>& X, const std::vector<Vec3>& U, double dt, int count)
{
  if (count == 0) return 0;
  double* __restrict x = X.data()->c;
  const double* __restrict u = U.data()->c;
  const std::ptrdiff_t n = 3 * count;
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

ImmersedBoundarySolver::ImmersedBoundarySolver(Hierarchy grid, std::vector<Opening> openings,
                                               const FluidParameters& fluid, const PressureOptions& pressure,
                                               std::unique_ptr<const ElasticModel> structure,
                                               StructureScheme scheme, Timers& timers,
                                               RefinementPolicy refinement, std::vector<MarkerSeed> seeds)
    : scheme_(scheme),
      timers_(timers),
      policy_(std::move(refinement)),
      grid_(std::make_unique<const Hierarchy>(std::move(grid))),
      fluid_(std::make_unique<NavierStokes>(*grid_, std::move(openings), fluid, pressure)),
      nodes_(std::move(structure), grid_->finest()),
      interaction_(grid_->finest()),
      elastic_(grid_->finest(), fluid.density),
      markers_(std::move(seeds)),
      f_(grid_->finest()),
      X_(nodes_.X()),
      X_of_cuts_(nodes_.whole().start()),
      X_of_grid_(nodes_.whole().start())
{
}

void ImmersedBoundarySolver::begin_step(double dt)
{
  dt_ = dt;
  const auto count = X_.size();
  U_.resize(count);
  const std::vector<Vec3>* forced_at = &X_;
  if (scheme_ == StructureScheme::midpoint) {
    const auto scope = timers_.time("interpolate");
    interaction_.interpolate(nodes_.first(), X_, fluid_->u().back(), U_);
    nodes_.part().add_slip(X_, dt, U_);
    X_middle_ = X_;
    if (!std::isfinite(move(X_middle_, U_, 0.5 * dt, nodes_.owned())))
      throw SolverError(
          "the velocity of a node of the structure is not finite; use a smaller time.cfl or "
          "time.elastic_safety");
    nodes_.fill_copies(X_middle_);
    forced_at = &X_middle_;
  }
  {
    const auto scope = timers_.time("fibre force");
    F_.assign(count, Vec3{0, 0, 0});
    nodes_.part().add_force(*forced_at, F_);
  }
  {
    const auto scope = timers_.time("spread");
    interaction_.spread(nodes_.first(), *forced_at, F_, f_);
  }
  const auto scope = timers_.time("momentum");
  // viscosity has its share of the same stretch of stability (scheme 5.1)
  cfl_ = dt * (courant_rate_ + 0.5 / viscous_step_limit(grid_->finest(), fluid_->fluid()));
  const bool keep = steps_since_convection_ < kStepsOfOneConvection &&
                    cfl_since_convection_ + cfl_ <= fluid_->fluid().convection_cfl;
  fluid_->begin_step(f_, dt, keep);
}

std::vector<double> ImmersedBoundarySolver::solve_fluid(const std::vector<double>& opening_pressure)
{
  const auto scope = timers_.time("projection");
  return fluid_->solve_pressure(opening_pressure);
}

void ImmersedBoundarySolver::accept(const std::vector<double>& phi)
{
  double fastest = 0;
  steps_since_convection_ = fluid_->rates_found() ? 1 : steps_since_convection_ + 1;
  cfl_since_convection_ = (fluid_->rates_found() ? 0 : cfl_since_convection_) + cfl_;
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
      nodes_.part().add_slip(X_middle_, dt_, U_);
    } else {
      interaction_.interpolate(nodes_.first(), X_, fluid_->u().back(), U_);
      nodes_.part().add_slip(X_, dt_, U_);
    }
    fastest = move(X_, U_, dt_, nodes_.owned());
    nodes_.fill_copies(X_);
  }
  if (markers_.wanted()) {
    const auto scope = timers_.time("markers");
    markers_.advance(*grid_, fluid_->u(), dt_);
  }
  const auto scope = timers_.time("step control");
  check_and_redistribute(dt_ * fastest / grid_->finest().h);
}

void ImmersedBoundarySolver::check_and_redistribute(double moved_cells)
{
  room_cells_ -= moved_cells;
  if (room_cells_ <= 0) room_cells_ = kNodeDrift - nodes_.farthest_out(X_);
  double state[3] = {fluid_->courant_rate(), room_cells_ <= 0 ? 1.0 : 0.0, moved_cells};
  MPI_Allreduce(MPI_IN_PLACE, state, 3, MPI_DOUBLE, MPI_MAX, grid_->comm());
  courant_rate_ = state[0];
  if (!std::isfinite(courant_rate_)) return;  // the step has blown up: CoupledModel says so
  moved_cells_ += policy_.vorticity > 0 ? std::max(state[2], dt_ * courant_rate_) : state[2];
  // What is not finite is for `redistribute` to refuse.
  if (policy_.levels > 1 && moved_cells_ > policy_.margin_cells - 0.5 && std::isfinite(moved_cells_))
    regrid_if_moved();
  if (state[1] == 0) return;
  nodes_.redistribute(X_);
  X_ = nodes_.X();
  room_cells_ = 0;
  elastic_.restart();
}

void ImmersedBoundarySolver::regrid_if_moved()
{
  const std::vector<Vec3> X = nodes_.gather(X_);
  const Hierarchy& grid = *grid_;
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
  auto grid = std::make_unique<const Hierarchy>(grid_->domain(), grid_->finest().h, grid_->comm(), boxes, X);
  fluid_ = std::make_unique<NavierStokes>(*grid, *fluid_);
  nodes_.move_to(grid->finest(), X);
  room_cells_ = 0;
  interaction_ = Interaction(grid->finest());
  elastic_ = ElasticBound(grid->finest(), fluid_->fluid().density);
  steps_since_elastic_ = 0;
  f_ = MacField(grid->finest());
  X_ = nodes_.X();
  X_of_cuts_ = X_of_grid_ = X;
  grid_ = std::move(grid);
  markers_.settle(*grid_);
}

double ImmersedBoundarySolver::elastic_rate()
{
  const auto scope = timers_.time("step control");
  if (steps_since_elastic_++ % kStepsBetweenElasticSweeps == 0) elastic_.update(nodes_, interaction_, X_, 1);
  return elastic_.omega();
}

void ImmersedBoundarySolver::save_or_restore(Checkpoint& c)
{
  std::vector<Vec3> X = X_of_cuts_;
  Refinement boxes = grid_->refinement();
  c("grid/cut_for_X", X);
  if (X.size() != X_of_cuts_.size())
    throw IoError(fmt::format("{}: {} nodes, but the case builds {}", c.path(), X.size(), X_of_cuts_.size()));
  ib3d::save_or_restore(c, "grid", boxes);
  const bool as_built = std::memcmp(X.data(), X_of_cuts_.data(), X.size() * sizeof(Vec3)) == 0;
  if (c.reading() && (!as_built || boxes != grid_->refinement())) rebuild(boxes, X);
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
  markers_.save_or_restore(c, *grid_);
}

}  // namespace valsalva::ib3d
