// The pressure problem: both solvers, the divergence they leave, inertance, hydrostatics.
#include <gtest/gtest.h>

#include <cmath>

#include "ib3d/fluid/navier_stokes.hpp"
#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

std::vector<Opening> two_discs()
{
  return {{"inlet", 4, {1.0, 1.0, 0}, 0.5, "lv"}, {"outlet", 5, {1.0, 1.0, 0}, 0.6, "ao"}};
}

void fill_at_random(const Level& level, CellField<double>& r)
{
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(level.local_box(p), [&](int i, int j, int k) {
      r[p](i, j, k) = std::sin(12.9898 * i + 78.233 * j + 37.719 * k + 0.1 * i * j);
    });
}

void fill_at_random(const Level& level, MacField& u)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_index(faces_of(level.local_box(p), c), [&](int i, int j, int k) {
        u(p, c)(i, j, k) = std::sin(1.7 * i + 2.3 * j - 3.1 * k + c);
      });
}

CellField<double> solution(const Level& level, const std::vector<Opening>& openings, const std::string& name,
                           int* iterations = nullptr)
{
  PressureSolver solver(level, openings, {name, 1e-3, 100});
  CellField<double> r(level), p(level);
  fill_at_random(level, r);
  const KrylovReport report = solver.solve(r, p, 1e-10);
  if (iterations != nullptr) *iterations = report.iterations;
  return p;
}

double largest_difference(const Level& level, const CellField<double>& a, const CellField<double>& b)
{
  double m = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(level.local_box(p),
                   [&](int i, int j, int k) { m = std::max(m, std::abs(a[p](i, j, k) - b[p](i, j, k))); });
  return m;
}

TEST(PressureSolver, MultilevelAndPfmgAgree)
{
  const Hierarchy grid(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_WORLD);
  const Level& level = grid.finest();
  int multilevel = 0, pfmg = 0;
  const CellField<double> a = solution(level, two_discs(), "multilevel", &multilevel);
  const CellField<double> b = solution(level, two_discs(), "pfmg", &pfmg);
  EXPECT_LT(largest_difference(level, a, b), 1e-8);
  EXPECT_LE(multilevel, 14);
  EXPECT_LE(pfmg, 25);
}

TEST(PressureSolver, AnswerDoesNotDependOnTheNumberOfBoxes)
{
  const Hierarchy one(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_WORLD),
      six(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_WORLD, 6);
  const CellField<double> a = solution(one.finest(), two_discs(), "multilevel");
  const CellField<double> b = solution(six.finest(), two_discs(), "multilevel");
  double m = 0;
  for (int p = 0; p < six.finest().local_count(); ++p)
    for (int q = 0; q < one.finest().local_count(); ++q)
      for_each_index(intersect(six.finest().local_box(p), one.finest().local_box(q)),
                     [&](int i, int j, int k) { m = std::max(m, std::abs(a[q](i, j, k) - b[p](i, j, k))); });
  EXPECT_LT(m, 1e-8);
}

TEST(PressureSolver, IterationsDoNotGrowWithTheGrid)
{
  std::vector<int> iterations;
  for (int n : {16, 32, 48}) {
    const Hierarchy grid(walled_box({2, 2, 6}), 2.0 / n, MPI_COMM_WORLD);
    solution(grid.finest(), two_discs(), "multilevel", &iterations.emplace_back());
  }
  EXPECT_LE(iterations[2], iterations[0] + 2);
}

TEST(NavierStokes, ProjectionLeavesDivergenceAtTolerance)
{
  for (const char* solver : {"multilevel", "pfmg"}) {
    const Hierarchy grid(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_WORLD);
    const Level& level = grid.finest();
    NavierStokes fluid(level, two_discs(), {}, {solver, 1e-6, 100});
    MacField f(level);
    fill_at_random(level, f);
    fluid.begin_step(f, 1e-2);
    fluid.solve_pressure({1000, 500});
    fluid.finish_step({30, -20});
    double square = 0, cells = 0;
    for (int p = 0; p < level.local_count(); ++p)
      for_each_index(level.local_box(p), [&](int i, int j, int k) {
        const MacField& u = fluid.u();
        const double div = (u(p, 0)(i + 1, j, k) - u(p, 0)(i, j, k) + u(p, 1)(i, j + 1, k) -
                            u(p, 1)(i, j, k) + u(p, 2)(i, j, k + 1) - u(p, 2)(i, j, k)) /
                           level.h;
        square += div * div;
        cells += 1;
      });
    double sums[2] = {square, cells};
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_LT(std::sqrt(sums[0] / sums[1]), 1.01e-6) << solver;
    EXPECT_GT(fluid.pressure_report().initial_rms, 1.0);
  }
}

TEST(OpeningModes, InertanceOfAStraightTubeIsRhoLengthOverArea)
{
  const Vec3 size{1, 2, 5};
  const Hierarchy grid(walled_box(size), 1.0 / 8, MPI_COMM_WORLD);
  const double rho = 1.06;
  PressureSolver solver(grid.finest(), both_ends(size), {});
  const OpeningModes modes(grid.finest(), both_ends(size), solver, rho);
  EXPECT_NEAR(1 / modes.conductance()(0, 0) / (rho * size[2] / (size[0] * size[1])), 1.0, 1e-6);
  EXPECT_NEAR(modes.conductance()(0, 1) / modes.conductance()(0, 0), -1.0, 1e-6);
}

TEST(NavierStokes, OpeningCorrectionByModesEqualsASolveWithTheCorrectedPressures)
{
  const Hierarchy grid(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_WORLD);
  const Level& level = grid.finest();
  MacField f(level);
  fill_at_random(level, f);
  std::vector<std::vector<double>> flows;
  for (const double part : {0.0, 700.0}) {
    NavierStokes fluid(level, two_discs(), {}, {"multilevel", 1e-9, 100});
    fluid.begin_step(f, 1e-3);
    fluid.solve_pressure({1000 - part, 500 + part});
    fluid.finish_step({part, -part});
    flows.push_back(flow_through(two_discs(), level, fluid.u()));
  }
  EXPECT_NEAR(flows[0][0], flows[1][0], 1e-8 * std::abs(flows[0][0]));
  EXPECT_NEAR(flows[0][0] + flows[0][1], 0, 1e-8 * std::abs(flows[0][0]));
}

TEST(NavierStokes, HydrostaticStatesAreExact)
{
  // A force that is a gradient (gravity along z), balanced by the opening pressures: nothing may move.
  const Vec3 size{2, 2, 6};
  const Hierarchy grid(walled_box(size), 2.0 / 16, MPI_COMM_WORLD);
  const Level& level = grid.finest();
  NavierStokes fluid(level, two_discs(), {}, {"multilevel", 1e-9, 100});
  MacField f(level);
  const double weight = -980;
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(faces_of(level.local_box(p), 2), [&](int i, int j, int k) {
      const bool end = k == level.box.lo[2] || k == level.box.hi[2];
      f(p, 2)(i, j, k) = end ? 0.0 : weight;
    });
  // On boundary faces the half cell beyond carries no weight: the column is one spacing shorter.
  const double column = weight * (size[2] - level.h);
  for (int step = 0; step < 5; ++step) {
    fluid.begin_step(f, 1e-3);
    fluid.solve_pressure({0, column});
    fluid.finish_step({0, 0});
  }
  EXPECT_LT(courant_rate(level, fluid.u()) * level.h, 1e-8);
}

}  // namespace
}  // namespace valsalva::ib3d
