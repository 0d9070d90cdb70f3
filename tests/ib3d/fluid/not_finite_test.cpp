// A number that is not finite is noticed, wherever it stands in a row, and an error inside hypre is told.
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_utilities.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "ib3d/fluid/courant_rate.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/pressure/hypre_pfmg.hpp"
#include "ib3d/fluid/viscous.hpp"
#include "ib3d/grid/row_kernels.hpp"
#include "ib3d/output/probes.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(NotFinite, MaximaOfRowsAreInfiniteForANanAnywhere)
{
  constexpr int n = 37;
  for (int at = 0; at < n; ++at) {
    std::vector<float> r(n, 2.0f);
    EXPECT_EQ(largest_in_row(r.data(), n), 2.0f);
    r[static_cast<std::size_t>(at)] = std::nanf("");
    EXPECT_TRUE(std::isinf(largest_in_row(r.data(), n)));

    std::vector<double> a(n, 3.0), b(n, 1.0);
    double largest[2] = {0, 0};
    compare_row(a.data(), b.data(), largest, n);
    EXPECT_EQ(largest[0], 2.0);
    EXPECT_EQ(largest[1], 1.0);
    b[static_cast<std::size_t>(at)] = kNan;
    compare_row(a.data(), b.data(), largest, n);
    EXPECT_TRUE(std::isinf(largest[0]));
  }
}

TEST(NotFinite, CourantRateIsInfiniteForANanOnAnyFace)
{
  const Hierarchy grid(walled_box({1, 1, 1}), 1.0 / 8, MPI_COMM_SELF);
  for (int c = 0; c < 3; ++c)
    for (const int i : {0, 3, 7}) {
      MacField u(grid.finest());
      u(0, c)(4, 5, 6) = 10;
      EXPECT_EQ(courant_rate(grid.finest(), u), 80);
      u(0, c)(i, 2, 1) = kNan;
      EXPECT_TRUE(std::isinf(courant_rate(grid.finest(), u)));
    }
}

TEST(NotFinite, TheViscousSolveRefusesIt)
{
  const Hierarchy grid(periodic_box({1, 1, 1}), 1.0 / 8, MPI_COMM_SELF);
  const auto as_they_are = [](CompositeMac&) {};
  for (const bool everywhere : {false, true}) {
    CompositeMac guess = composite_faces(grid), u = composite_faces(grid);
    EXPECT_EQ(ViscousSolver(grid).solve(1e-4, guess, u, as_they_are), 1);
    for_each_index(u[0](0, 1).stored(), [&](int i, int j, int k) {
      if (everywhere || (i == 3 && j == 4 && k == 5)) u[0](0, 1)(i, j, k) = kNan;
    });
    EXPECT_THROW(ViscousSolver(grid).solve(1e-4, guess, u, as_they_are), SolverError);
  }
}

TEST(NotFinite, AnOrificeWithANodeThatIsLostHasNoArea)
{
  std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  EXPECT_EQ(orifice_area(square), 4);
  square[2][1] = kNan;
  EXPECT_TRUE(std::isnan(orifice_area(square)));
}

TEST(HyprePfmg, AnErrorOfHypreBecomesASolverErrorWithItsDescription)
{
  const Hierarchy grid(walled_box({1, 1, 1}), 1.0 / 8, MPI_COMM_SELF);
  const PressureGrid problem(grid, 0, both_ends({1, 1, 1}));
  HyprePfmg pfmg(problem, 1);
  CellField<float> r(grid.finest()), z(grid.finest());
  r[0](3, 4, 5) = 1;
  pfmg.solve(r, z);
  HYPRE_Solver amg = nullptr;
  HYPRE_BoomerAMGCreate(&amg);
  HYPRE_BoomerAMGSetTol(amg, -1);  // hypre notes "error in argument 2"
  HYPRE_BoomerAMGDestroy(amg);
  try {
    pfmg.solve(r, z);
    FAIL() << "the error went unseen";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("argument 2"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(pfmg.solve(r, z));
  HYPRE_BoomerAMGCreate(&amg);
  HYPRE_BoomerAMGSetTol(amg, -1);
  HYPRE_BoomerAMGDestroy(amg);
  EXPECT_THROW(HyprePfmg(problem, 1), SolverError);
}

}  // namespace
}  // namespace valsalva::ib3d
