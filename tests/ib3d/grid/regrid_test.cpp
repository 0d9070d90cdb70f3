// Carrying a flow to other refined boxes: no divergence appears, smooth fields come over to the order of interpolation.
#include "ib3d/grid/regrid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/navier_stokes.hpp"
#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {
namespace {

Hierarchy grid_with_box(const IndexBox& fine, int n = 16)
{
  return Hierarchy(walled_box({1, 1, 2}), 1.0 / (2 * n), MPI_COMM_WORLD, Refinement{{fine}}, {}, 3);
}

double divergence_rms(const NavierStokes& fluid)
{
  double sums[2] = {0, 0};
  for_each_valid_cell(fluid.grid(), [&](std::size_t l, int p, int i, int j, int k) {
    const MacField& u = fluid.u()[l];
    const double h = fluid.grid().levels()[l].h;
    const double div = (u(p, 0)(i + 1, j, k) - u(p, 0)(i, j, k) + u(p, 1)(i, j + 1, k) - u(p, 1)(i, j, k) +
                        u(p, 2)(i, j, k + 1) - u(p, 2)(i, j, k)) /
                       h;
    sums[0] += h * h * h * div * div;
    sums[1] += h * h * h;
  });
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return std::sqrt(sums[0] / sums[1]);
}

TEST(Regrid, LeavesTheDivergenceAtTolerance)
{
  const Hierarchy before = grid_with_box({{8, 8, 16}, {24, 24, 40}}),
                  after = grid_with_box({{0, 8, 8}, {16, 24, 64}});
  NavierStokes fluid(before, {}, {}, {"multilevel", 1e-9, 100});
  CompositeMac f = composite_faces(before);
  for (std::size_t l = 0; l < f.size(); ++l)
    fill_faces(before.levels()[l], f[l],
               [](int c, const Vec3& x) { return std::sin(31 * x[0] - 17 * x[1] + 23 * x[2] + c); });
  fluid.begin_step(f, 0.1);
  fluid.solve_pressure({});
  fluid.finish_step({});
  ASSERT_LT(divergence_rms(fluid), 1.1e-9);
  const NavierStokes moved(after, fluid);
  EXPECT_LT(divergence_rms(moved), 2e-9);
  EXPECT_GT(moved.courant_rate(), 0.05);
}

TEST(Regrid, SmoothVelocityComesOverToSecondOrder)
{
  const auto error = [](int n) {
    const int b = n / 2;  // boxes grow with the grid
    const Hierarchy before = grid_with_box({{b, b, b}, {3 * b, 3 * b, 3 * b}}, n);
    const Hierarchy after = grid_with_box({{0, b, 2 * b}, {2 * b, 3 * b, 6 * b}}, n);
    // A field without divergence, at rest on the walls.
    const auto flow = [](int c, const Vec3& x) {
      const double sx = std::sin(M_PI * x[0]), sy = std::sin(M_PI * x[1]);
      return c == 0   ? sx * sx * sy * std::cos(M_PI * x[1])
             : c == 1 ? -sy * sy * sx * std::cos(M_PI * x[0])
                      : 0.0;
    };
    NavierStokes fluid(before, {}, {}, {"multilevel", 1e-9, 100});
    CompositeMac u = composite_faces(before);
    for (std::size_t l = 0; l < u.size(); ++l) fill_faces(before.levels()[l], u[l], flow);
    fluid.set_velocity(u);
    const NavierStokes moved(after, fluid);
    CompositeMac exact = composite_faces(after);
    double largest = 0;
    const Level& fine = after.finest();
    fill_faces(fine, exact[1], flow);
    for (int p = 0; p < fine.local_count(); ++p)
      for (int c = 0; c < 3; ++c)
        for_each_owned_face(fine, p, c, [&](int i, int j, int k) {
          largest = max_or_nan(largest, std::abs(moved.u()[1](p, c)(i, j, k) - exact[1](p, c)(i, j, k)));
        });
    return largest;
  };
  EXPECT_GT(std::log2(error(16) / error(32)), 1.8);
}

TEST(Regrid, EveningOutKeepsTheNetFluxOfEveryCoarseCell)
{
  const IndexBox coarse{{0, 0, 0}, {2, 2, 2}};
  std::array<Array3<double>, 3> u;
  for (std::size_t d = 0; d < 3; ++d) {
    u[d] = Array3<double>(stored_box(coarse.refined(), 1));
    for_each_index(u[d].stored(), [&](int i, int j, int k) {
      u[d](i, j, k) = std::sin(3.1 * i + 5.7 * j - 2.3 * k + static_cast<double>(d));
    });
  }
  const std::array<Array3<double>, 3> before = u;
  even_out_divergence(coarse, {&u[0], &u[1], &u[2]});
  const auto divergence = [](const std::array<Array3<double>, 3>& v, int i, int j, int k) {
    return v[0](i + 1, j, k) - v[0](i, j, k) + v[1](i, j + 1, k) - v[1](i, j, k) + v[2](i, j, k + 1) -
           v[2](i, j, k);
  };
  for_each_index(coarse, [&](int ci, int cj, int ck) {
    double net = 0;
    const IndexBox eight{{2 * ci, 2 * cj, 2 * ck}, {2 * ci + 2, 2 * cj + 2, 2 * ck + 2}};
    for_each_index(eight, [&](int i, int j, int k) { net += divergence(before, i, j, k); });
    for_each_index(eight, [&](int i, int j, int k) { EXPECT_NEAR(divergence(u, i, j, k), net / 8, 1e-13); });
  });
}

}  // namespace
}  // namespace valsalva::ib3d
