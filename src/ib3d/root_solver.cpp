#include "ib3d/root_solver.hpp"

#include "ib3d/structure/fiber_force.hpp"

namespace valsalva::ib3d {

namespace {

constexpr int kStepsBetweenElasticSweeps = 30;

}  // namespace

RootSolver::RootSolver(const Hierarchy& grid, std::vector<Opening> openings, const FluidParameters& fluid,
                       const PressureOptions& pressure, FiberNetwork structure, StructureScheme scheme,
                       Timers& timers)
    : scheme_(scheme),
      timers_(timers),
      fluid_(grid, std::move(openings), fluid, pressure),
      nodes_(std::move(structure), grid.finest()),
      interaction_(grid.finest()),
      elastic_(grid.finest(), fluid.density),
      f_(grid.finest()),
      X_(nodes_.part().network.X)
{
}

void RootSolver::begin_step(double dt)
{
  dt_ = dt;
  const auto count = X_.size();
  U_.resize(count);
  F_.resize(count);
  const std::vector<Vec3>* forced_at = &X_;
  if (scheme_ == StructureScheme::midpoint) {
    const auto scope = timers_.time("interpolate");
    interaction_.interpolate(nodes_.first(), X_, fluid_.u().back(), U_);
    X_middle_.resize(count);
    for (std::size_t n = 0; n < count; ++n) X_middle_[n] = X_[n] + 0.5 * dt * U_[n];
    nodes_.fill_copies(X_middle_);
    forced_at = &X_middle_;
  }
  {
    const auto scope = timers_.time("fibre force");
    fiber_force(nodes_.part().network, *forced_at, F_);
  }
  {
    const auto scope = timers_.time("spread");
    interaction_.spread(nodes_.first(), *forced_at, F_, f_);
  }
  const auto scope = timers_.time("momentum");
  fluid_.begin_step(f_, dt);
}

std::vector<double> RootSolver::solve_fluid(const std::vector<double>& opening_pressure)
{
  const auto scope = timers_.time("projection");
  return fluid_.solve_pressure(opening_pressure);
}

void RootSolver::accept(const std::vector<double>& phi)
{
  {
    const auto scope = timers_.time("projection");
    fluid_.finish_step(phi);
  }
  {
    const auto scope = timers_.time("interpolate");
    if (scheme_ == StructureScheme::midpoint) {
      U_before_.resize(U_.size());
      interaction_.interpolate(nodes_.first(), X_middle_, fluid_.u_before().back(), U_before_);
      interaction_.interpolate(nodes_.first(), X_middle_, fluid_.u().back(), U_);
      for (std::size_t n = 0; n < U_.size(); ++n) U_[n] = 0.5 * (U_[n] + U_before_[n]);
    } else {
      interaction_.interpolate(nodes_.first(), X_, fluid_.u().back(), U_);
    }
    for (int n = 0; n < nodes_.owned(); ++n)
      X_[static_cast<std::size_t>(n)] += dt_ * U_[static_cast<std::size_t>(n)];
    nodes_.fill_copies(X_);
  }
  const auto scope = timers_.time("step control");
  check_and_redistribute();
}

void RootSolver::check_and_redistribute()
{
  double state[2] = {fluid_.courant_rate(), nodes_.has_strays(X_) ? 1.0 : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, state, 2, MPI_DOUBLE, MPI_MAX, fluid_.grid().comm());
  courant_rate_ = state[0];
  if (state[1] == 0) return;
  X_ = nodes_.redistribute(X_);
  elastic_.restart();
}

double RootSolver::elastic_rate()
{
  const auto scope = timers_.time("step control");
  if (steps_since_elastic_++ % kStepsBetweenElasticSweeps == 0) elastic_.update(nodes_, interaction_, X_, 1);
  return elastic_.omega();
}

void RootSolver::save_or_restore(Checkpoint& c)
{
  fluid_.save_or_restore(c);
  nodes_.save_or_restore(c);
  nodes_.save_or_restore(c, "structure/X", X_);
  if (c.reading()) check_and_redistribute();  // other ranks may have other patches
  elastic_.save_or_restore(c, nodes_);
  c("structure/steps_since_elastic", steps_since_elastic_);
}

}  // namespace valsalva::ib3d
