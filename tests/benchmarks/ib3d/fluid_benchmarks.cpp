// Cost of the fluid solver: momentum with each flux (per cell, all three components), the implicit viscous solve, one
// V-cycle, one pressure solve. "per_cell" is a time: 20n is 20 ns.
#include <benchmark/benchmark.h>

#include "ib3d/fluid/advection.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/navier_stokes.hpp"
#include "ib3d/fluid/pressure/multilevel.hpp"

namespace valsalva::ib3d {
namespace {

const Vec3 kSize{10, 10, 15};

/// About half a million cells on one level, or in the valid cells of three.
Hierarchy grid_of(int levels)
{
  return levels == 1 ? nested_grid(walled_box(kSize), 10.0 / 72, 1)
                     : nested_grid(walled_box(kSize), 10.0 / 40, levels, true);
}

std::vector<Opening> openings()
{
  return {{"inlet", Side::z_lo, {5, 5, 0}, 1.1, "lv"}, {"outlet", Side::z_hi, {5, 5, 0}, 1.2, "ao"}};
}

/// Of order 1 and not smooth, so that limiters have work.
CompositeMac rough_faces(const Hierarchy& grid)
{
  CompositeMac u = composite_faces(grid);
  for (MacField& level : u)
    for (int p = 0; p < level.patch_count(); ++p)
      for (int c = 0; c < 3; ++c)
        for_each_index(level(p, c).stored(), [&](int i, int j, int k) {
          level(p, c)(i, j, k) =
              std::sin(0.3 * i + c) * std::cos(0.5 * j - 0.2 * k) + 0.1 * std::sin(7.1 * i * j + k);
        });
  return u;
}

benchmark::Counter each(double count)
{
  return benchmark::Counter(count,
                            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void convection(benchmark::State& state, Advection advection)
{
  const Hierarchy grid = grid_of(1);
  const CompositeMac u = rough_faces(grid);
  double sum = 0;
  for (auto _ : state)
    for (int c = 0; c < 3; ++c)
      for_each_convected_row(advection, {&u[0](0, 0), &u[0](0, 1), &u[0](0, 2)}, c,
                             faces_of(grid.finest().local_box(0), c),
                             [&](int, int, const double* div) { sum += div[0]; });
  benchmark::DoNotOptimize(sum);
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK_CAPTURE(convection, limited, Advection::limited)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(convection, xsppm7, Advection::xsppm7)->Unit(benchmark::kMillisecond);

void momentum(benchmark::State& state, Advection advection)
{
  const Hierarchy grid = grid_of(1);
  const CompositeMac u = rough_faces(grid), f = rough_faces(grid);
  CompositeMac rate = composite_faces(grid), before = composite_faces(grid), u_star = composite_faces(grid);
  for (auto _ : state)
    advance_momentum(grid.finest(), {1.0, 0.04, advection}, u[0], &f[0], 1e-4, -0.5, rate[0], before[0],
                     u_star[0]);
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK_CAPTURE(momentum, none, Advection::none)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(momentum, limited, Advection::limited)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(momentum, xsppm7, Advection::xsppm7)->Unit(benchmark::kMillisecond);

/// A step that keeps the rates: most of them in diastole.
void momentum_kept(benchmark::State& state)
{
  const Hierarchy grid = grid_of(1);
  const CompositeMac u = rough_faces(grid), f = rough_faces(grid), rate = u, before = f;
  CompositeMac u_star = composite_faces(grid);
  for (auto _ : state)
    advance_momentum_kept(grid.finest(), {}, u[0], &f[0], 1e-4, -0.5, rate[0], before[0], u_star[0]);
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK(momentum_kept)->Unit(benchmark::kMillisecond);

/// One whole step; with Crank-Nicolson it holds the viscous solve.
void step(benchmark::State& state, ViscosityScheme viscosity)
{
  const Hierarchy grid = grid_of(static_cast<int>(state.range(0)));
  NavierStokes fluid(grid, openings(), {1.0, 0.04, Advection::xsppm7, 0, viscosity}, {});
  fluid.set_velocity(rough_faces(grid));
  const CompositeMac none = composite_faces(grid);
  for (auto _ : state) {
    fluid.begin_step(none, 1e-4);
    fluid.solve_pressure({1e4, 0});
    fluid.finish_step({0, 0});
  }
  state.counters["sweeps"] = fluid.viscous_sweeps();
  state.counters["iterations"] = fluid.pressure_report().iterations;
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK_CAPTURE(step, explicit_viscosity, ViscosityScheme::explicit_)
    ->Arg(1)
    ->Arg(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, crank_nicolson, ViscosityScheme::crank_nicolson)
    ->Arg(1)
    ->Arg(3)
    ->Unit(benchmark::kMillisecond);

void v_cycle(benchmark::State& state)
{
  const Hierarchy grid = grid_of(static_cast<int>(state.range(0)));
  std::vector<CoarseFine> transfers = transfers_between_levels(grid);
  CompositePressure problem(grid, openings(), transfers);
  Multilevel multigrid(problem);
  CompositeCells<float> r = composite_cells<float>(grid), z = composite_cells<float>(grid);
  for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
    r[l][p](i, j, k) = static_cast<float>(std::sin(7.1 * i * j + k));
  });
  for (auto _ : state) multigrid.apply(r, z);
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK(v_cycle)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

/// From zero, for a divergence that is rough from cell to cell, until it has fallen by 1e-6.
void cold_projection(benchmark::State& state)
{
  const Hierarchy grid = grid_of(static_cast<int>(state.range(0)));
  std::vector<CoarseFine> transfers = transfers_between_levels(grid);
  PressureSolver solver(grid, openings(), {}, transfers);
  CompositeMac u = rough_faces(grid);
  for (std::size_t l = u.size() - 1; l > 0; --l) transfers[l - 1].average_down(u[l], u[l - 1]);
  CompositeCells<double> p = composite_cells<double>(grid);
  const std::vector<BoundaryPressure> p_b = solver.problem().zero_boundary_pressure();
  const double rms = solver.solve(p, p_b, &u, 1.0, 1e30, 60).initial_rms;
  KrylovReport report;
  for (auto _ : state) {
    for (CellField<double>& level : p) level.set_zero();
    report = solver.solve(p, p_b, &u, 1.0, 1e-6 * rms, 60);
  }
  state.counters["iterations"] = report.iterations;
  state.counters["per_cell"] = each(static_cast<double>(grid.valid_cell_count()));
}
BENCHMARK(cold_projection)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace valsalva::ib3d
