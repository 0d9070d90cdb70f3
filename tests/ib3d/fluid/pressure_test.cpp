// The pressure problem on one and on several levels: two solvers, any boxes, the divergence they leave, the modes of the
// openings.
#include <gtest/gtest.h>

#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/navier_stokes.hpp"

namespace valsalva::ib3d {
namespace {

/// Discs well inside the refined boxes of nested_grid.
std::vector<Opening> two_discs()
{
  return {{"inlet", Side::z_lo, {1, 1, 0}, 0.4, "lv"}, {"outlet", Side::z_hi, {1, 1, 0}, 0.3, "ao"}};
}

Hierarchy test_grid(int levels, int boxes = 0)
{
  return nested_grid(walled_box({2, 2, 6}), 2.0 / 16, levels, true, boxes);
}

/// Values that depend on the place only, the same wherever the boxes are cut.
double rough(double x, double y, double z)
{
  return std::sin(27.2 * x + 36.8 * y - 49.6 * z) + std::cos(7.1 * x * y + z);
}

CompositeMac rough_faces(const Hierarchy& grid)
{
  CompositeMac u = composite_faces(grid);
  for (int l = 0; l < grid.level_count(); ++l)
    for (int p = 0; p < grid.level(l).local_count(); ++p)
      for (int c = 0; c < 3; ++c)
        for_each_index(faces_of(grid.level(l).local_box(p), c), [&](int i, int j, int k) {
          const double h = grid.level(l).h;
          u[static_cast<std::size_t>(l)](p, c)(i, j, k) = rough(i * h + c, j * h, k * h);
        });
  return u;
}

struct Solution {
  CompositeCells<double> p;
  KrylovReport report;
};

/// Solves with a divergence that is rough from cell to cell.
Solution solution(const Hierarchy& grid, const std::string& name, double tolerance = 1e-10)
{
  std::vector<CoarseFine> transfers = transfers_between_levels(grid);
  PressureSolver solver(grid, two_discs(), {name, 1e-3, 100}, transfers);
  CompositeMac u = rough_faces(grid);
  for (std::size_t l = u.size() - 1; l > 0; --l) transfers[l - 1].average_down(u[l], u[l - 1]);
  Solution s{composite_cells<double>(grid), {}};
  s.report = solver.solve(s.p, solver.problem().zero_boundary_pressure(), &u, 1.0, tolerance, 100);
  return s;
}

TEST(PressureSolver, MultilevelAndPfmgAgree)
{
  const Hierarchy grid = test_grid(1);
  const Solution a = solution(grid, "multilevel"), b = solution(grid, "pfmg");
  double m = 0;
  for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
    m = max_or_nan(m, std::abs(a.p[l][p](i, j, k) - b.p[l][p](i, j, k)));
  });
  EXPECT_LT(m, 1e-8);
  EXPECT_LE(a.report.iterations, 16);
  EXPECT_LE(b.report.iterations, 25);
}

TEST(PressureSolver, AnswerDoesNotDependOnTheNumberOfBoxes)
{
  for (const int levels : {1, 3}) {
    const Hierarchy one = test_grid(levels), six = test_grid(levels, 6);
    const Solution a = solution(one, "multilevel"), b = solution(six, "multilevel");
    double m = 0;
    for (std::size_t l = 0; l < a.p.size(); ++l) {
      const Level &first = one.levels()[l], &second = six.levels()[l];
      for (int p = 0; p < second.local_count(); ++p)
        for (int q = 0; q < first.local_count(); ++q)
          for_each_index(intersect(second.local_box(p), first.local_box(q)), [&](int i, int j, int k) {
            m = max_or_nan(m, std::abs(a.p[l][q](i, j, k) - b.p[l][p](i, j, k)));
          });
    }
    EXPECT_LT(m, 1e-8) << levels;
  }
}

TEST(PressureSolver, IterationsGrowNeitherWithTheGridNorWithTheLevels)
{
  const auto iterations = [](int n, int levels) {
    return solution(nested_grid(walled_box({2, 2, 6}), 2.0 / n, levels, true), "multilevel", 1e-4)
        .report.iterations;
  };
  const int least = iterations(16, 1);
  for (const int n : {32, 48}) EXPECT_LE(iterations(n, 1), least + 2) << n;
  for (const int levels : {2, 3}) {
    const int needed = iterations(16, levels);
    RecordProperty("iterations on " + std::to_string(levels) + " levels", needed);
    EXPECT_LE(needed, least + 3) << levels;
  }
}

TEST(NavierStokes, ProjectionLeavesDivergenceAtTolerance)
{
  for (const int levels : {1, 2, 3})
    for (const char* solver : {"multilevel", "pfmg"}) {
      if (levels > 1 && std::string(solver) == "pfmg") continue;
      const Hierarchy grid = test_grid(levels);
      NavierStokes fluid(grid, two_discs(), {}, {solver, 1e-6, 100});
      fluid.begin_step(rough_faces(grid), 1e-2);
      fluid.solve_pressure({1000, 500});
      fluid.finish_step({30, -20});
      double sums[2] = {0, 0};
      for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
        const MacField& u = fluid.u()[l];
        const double h = grid.levels()[l].h;
        const double div = (u(p, 0)(i + 1, j, k) - u(p, 0)(i, j, k) + u(p, 1)(i, j + 1, k) -
                            u(p, 1)(i, j, k) + u(p, 2)(i, j, k + 1) - u(p, 2)(i, j, k)) /
                           h;
        sums[0] += h * h * h * div * div;
        sums[1] += h * h * h;
      });
      MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
      EXPECT_LT(std::sqrt(sums[0] / sums[1]), 1.05e-6) << solver << " " << levels;
      EXPECT_GT(fluid.pressure_report().initial_rms, 1.0);
    }
}

TEST(OpeningModes, InertanceOfAStraightTubeIsRhoLengthOverArea)
{
  const Vec3 size{1, 2, 5};
  const double rho = 1.06;
  for (const int levels : {1, 2}) {
    const Hierarchy grid = nested_grid(walled_box(size), 1.0 / 16, levels);
    std::vector<CoarseFine> transfers = transfers_between_levels(grid);
    PressureSolver solver(grid, both_ends(size), {}, transfers);
    const OpeningModes modes(OpeningFaces(grid, both_ends(size)), solver, rho);
    EXPECT_NEAR(1 / modes.conductance()(0, 0) / (rho * size[2] / (size[0] * size[1])), 1.0, 1e-6) << levels;
    EXPECT_NEAR(modes.conductance()(0, 1) / modes.conductance()(0, 0), -1.0, 1e-6) << levels;
  }
}

TEST(NavierStokes, OpeningCorrectionByModesEqualsASolveWithTheCorrectedPressures)
{
  for (const int levels : {1, 2}) {
    const Hierarchy grid = test_grid(levels);
    std::vector<std::vector<double>> flows;
    for (const double part : {0.0, 700.0}) {
      NavierStokes fluid(grid, two_discs(), {}, {"multilevel", 1e-9, 100});
      fluid.begin_step(rough_faces(grid), 1e-3);
      fluid.solve_pressure({1000 - part, 500 + part});
      fluid.finish_step({part, -part});
      flows.push_back(OpeningFaces(grid, two_discs()).flow(fluid.u()));
    }
    EXPECT_NEAR(flows[0][0], flows[1][0], 1e-8 * std::abs(flows[0][0]));
    EXPECT_NEAR(flows[0][0] + flows[0][1], 0, 1e-8 * std::abs(flows[0][0]));
  }
}

TEST(NavierStokes, HydrostaticStatesAreExact)
{
  // A force that is a gradient (gravity along z), balanced by the opening pressures: nothing may move.
  const Vec3 size{2, 2, 6};
  for (const int levels : {1, 2, 3}) {
    const Hierarchy grid = test_grid(levels);
    NavierStokes fluid(grid, two_discs(), {}, {"multilevel", 1e-9, 100});
    CompositeMac f = composite_faces(grid);
    const double weight = -980;
    for (int l = 0; l < levels; ++l)
      for (int p = 0; p < grid.level(l).local_count(); ++p)
        for_each_index(faces_of(grid.level(l).local_box(p), 2),
                       [&](int i, int j, int k) { f[static_cast<std::size_t>(l)](p, 2)(i, j, k) = weight; });
    const double column = weight * size[2];
    for (int step = 0; step < 5; ++step) {
      fluid.begin_step(f, 1e-3);
      fluid.solve_pressure({0, column});
      fluid.finish_step({0, 0});
    }
    EXPECT_LT(fluid.courant_rate() * grid.finest().h, 1e-7) << levels;
  }
}

}  // namespace
}  // namespace valsalva::ib3d
