// The composite pressure problem against itself as an assembled matrix, solved by hypre's BoomerAMG: the operator is
// probed cell by cell, so nothing of the multilevel solver is shared but the operator.
#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_utilities.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/pressure/pressure_solver.hpp"

namespace valsalva::ib3d {
namespace {

struct Cell {
  std::size_t l;
  int p, i, j, k;
};

float& at(CompositeCells<float>& a, const Cell& c)
{
  return a[c.l][c.p](c.i, c.j, c.k);
}

/// Solves A x = b, A given by columns, with BoomerAMG.
std::vector<double> solve_assembled(const std::vector<std::vector<std::pair<int, double>>>& rows,
                                    const std::vector<double>& b)
{
  const int n = static_cast<int>(b.size());
  HYPRE_Init();
  HYPRE_IJMatrix A = nullptr;
  HYPRE_IJVector rhs = nullptr, x = nullptr;
  HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, n - 1, 0, n - 1, &A);
  HYPRE_IJMatrixSetObjectType(A, HYPRE_PARCSR);
  HYPRE_IJMatrixInitialize(A);
  for (int r = 0; r < n; ++r) {
    std::vector<int> columns;
    std::vector<double> values;
    for (const auto& [c, v] : rows[static_cast<std::size_t>(r)]) {
      columns.push_back(c);
      values.push_back(v);
    }
    int count = static_cast<int>(columns.size());
    HYPRE_IJMatrixSetValues(A, 1, &count, &r, columns.data(), values.data());
  }
  HYPRE_IJMatrixAssemble(A);
  std::vector<int> numbers(b.size());
  for (int r = 0; r < n; ++r) numbers[static_cast<std::size_t>(r)] = r;
  for (HYPRE_IJVector* v : {&rhs, &x}) {
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, n - 1, v);
    HYPRE_IJVectorSetObjectType(*v, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(*v);
  }
  HYPRE_IJVectorSetValues(rhs, n, numbers.data(), b.data());
  HYPRE_IJVectorAssemble(rhs);
  HYPRE_IJVectorAssemble(x);
  void *matrix = nullptr, *right = nullptr, *left = nullptr;
  HYPRE_IJMatrixGetObject(A, &matrix);
  HYPRE_IJVectorGetObject(rhs, &right);
  HYPRE_IJVectorGetObject(x, &left);
  HYPRE_Solver amg = nullptr;
  HYPRE_BoomerAMGCreate(&amg);
  HYPRE_BoomerAMGSetTol(amg, 1e-11);
  HYPRE_BoomerAMGSetMaxIter(amg, 200);
  HYPRE_BoomerAMGSetup(amg, static_cast<HYPRE_ParCSRMatrix>(matrix), static_cast<HYPRE_ParVector>(right),
                       static_cast<HYPRE_ParVector>(left));
  HYPRE_BoomerAMGSolve(amg, static_cast<HYPRE_ParCSRMatrix>(matrix), static_cast<HYPRE_ParVector>(right),
                       static_cast<HYPRE_ParVector>(left));
  std::vector<double> solution(b.size());
  HYPRE_IJVectorGetValues(x, n, numbers.data(), solution.data());
  HYPRE_BoomerAMGDestroy(amg);
  HYPRE_IJMatrixDestroy(A);
  HYPRE_IJVectorDestroy(rhs);
  HYPRE_IJVectorDestroy(x);
  return solution;
}

TEST(PressureSolver, CompositeSolutionIsThatOfBoomerAmgOnTheAssembledMatrix)
{
  const Hierarchy grid = nested_grid(walled_box({1, 1, 1}), 1.0 / 16, 2, true);
  const std::vector<Opening> discs{{"inlet", Side::z_lo, {0.5, 0.5, 0}, 0.2, "lv"},
                                   {"outlet", Side::z_hi, {0.5, 0.5, 0}, 0.15, "ao"}};
  std::vector<CoarseFine> transfers = transfers_between_levels(grid);
  PressureSolver solver(grid, discs, {"multilevel", 1e-3, 100}, transfers);
  CompositePressure& problem = solver.problem();

  std::vector<Cell> cells;
  for_each_valid_cell(grid, [&](std::size_t l, int p, int i, int j, int k) {
    cells.push_back({l, p, i, j, k});
  });
  CompositeCells<float> unit = composite_cells<float>(grid), image = composite_cells<float>(grid);
  std::vector<std::vector<std::pair<int, double>>> rows(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (CellField<float>& level : unit) level.set_zero();
    at(unit, cells[c]) = 1;
    problem.apply(unit, unit, image);
    for (std::size_t r = 0; r < cells.size(); ++r)
      if (const float a = at(image, cells[r]); a != 0)
        rows[r].push_back({static_cast<int>(c), static_cast<double>(a)});
  }

  // h^2 (-lap p) = h^2 b for a divergence that is rough from cell to cell.
  CompositeMac u = composite_faces(grid);
  for (std::size_t l = 0; l < u.size(); ++l)
    for (int c = 0; c < 3; ++c)
      for_each_index(faces_of(grid.levels()[l].local_box(0), c), [&](int i, int j, int k) {
        const double h = grid.levels()[l].h;
        u[l](0, c)(i, j, k) = std::sin(27 * i * h + 36 * j * h - 49 * k * h + c);
      });
  transfers[0].average_down(u[1], u[0]);
  const std::vector<BoundaryPressure> zero = problem.zero_boundary_pressure();
  CompositeCells<double> p = composite_cells<double>(grid);
  CompositeCells<float> r = composite_cells<float>(grid);
  problem.residual(p, zero, &u, 1.0, r);
  std::vector<double> b;
  for (const Cell& c : cells) b.push_back(static_cast<double>(at(r, c)));
  const std::vector<double> expected = solve_assembled(rows, b);

  solver.solve(p, zero, &u, 1.0, 1e-9, 100);
  double largest = 0, difference = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    largest = max_or_nan(largest, std::abs(expected[c]));
    difference = max_or_nan(
        difference, std::abs(expected[c] - p[cells[c].l][cells[c].p](cells[c].i, cells[c].j, cells[c].k)));
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(difference, 1e-5 * largest);  // the matrix is probed in single precision
}

}  // namespace
}  // namespace valsalva::ib3d
