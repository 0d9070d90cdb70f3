// No direction is special to the fluid: with domain, refined boxes, openings, force and start turned so that z becomes x
// or y, the flow is the same flow turned, to the tolerance of the pressure solve.
#include <gtest/gtest.h>

#include <cmath>

#include "common/max_or_nan.hpp"
#include "ib3d/fluid/order.hpp"
#include "ib3d/output/probes.hpp"

namespace valsalva::ib3d {
namespace {

/// Direction d becomes direction (d + by) mod 3.
struct Turn {
  int by;
  int operator()(int d) const { return (d + by) % 3; }
  template <class T, class Index>
  T all(const T& x) const
  {
    T turned{};
    for (int d = 0; d < 3; ++d) turned[static_cast<Index>((*this)(d))] = x[static_cast<Index>(d)];
    return turned;
  }
  Vec3 operator()(const Vec3& x) const { return all<Vec3, int>(x); }
  Int3 operator()(const Int3& i) const { return all<Int3, std::size_t>(i); }
  Vec3 back(const Vec3& x) const { return Turn{3 - by}(x); }
  IndexBox operator()(const IndexBox& b) const { return {(*this)(b.lo), (*this)(b.hi)}; }
  Side operator()(Side s) const
  {
    return kSides[static_cast<std::size_t>(2 * (*this)(axis(s)) + (is_high(s) ? 1 : 0))];
  }
};

double rough(int c, const Vec3& x)
{
  return 5 * std::sin(3 * x[0] + 2 * x[1] - 4 * x[2] + c) + std::cos(7 * x[0] * x[1] + c * x[2]);
}

/// Some steps into a box through the bottom and out of it through a side, all turned.
struct Flow {
  Hierarchy grid;
  NavierStokes fluid;
  std::vector<double> flow, corrected;

  static Hierarchy turned_grid(const Turn& turn, int levels)
  {
    const Domain domain = walled_box({2, 3, 4});
    Refinement boxes = nested_grid(domain, 0.125, levels).refinement();
    for (std::vector<IndexBox>& level : boxes)
      for (IndexBox& box : level) box = turn(box);
    return Hierarchy(walled_box(turn(domain.size)), 0.125 / (1 << (levels - 1)), MPI_COMM_SELF, boxes);
  }
  Flow(const Turn& turn, int levels, const FluidParameters& parameters)
      : grid(turned_grid(turn, levels)),
        fluid(grid,
              {{"in", turn(Side::z_lo), turn(Vec3{0.9, 1.6, 0}), 0.5, "lv"},
               {"out", turn(Side::x_hi), turn(Vec3{0, 1.4, 2.3}), 0.6, "ao"}},
              parameters, {"multilevel", 1e-10, 100})
  {
    CompositeMac field = composite_faces(grid);
    for (std::size_t l = 0; l < field.size(); ++l)
      fill_faces(grid.levels()[l], field[l],
                 [&](int c, const Vec3& x) { return rough((c + 3 - turn.by) % 3, turn.back(x)); });
    fluid.set_velocity(field);
    for (int step = 0; step < 3; ++step) {
      fluid.begin_step(field, 2e-3);
      flow = fluid.solve_pressure({900, -200});
      fluid.finish_step({50, 20});
    }
    corrected = OpeningFaces(grid, fluid.openings()).flow(fluid.u());
  }
};

void expect_turned_flow(int by, int levels, const FluidParameters& parameters)
{
  const Turn turn{by};
  const Flow straight({0}, levels, parameters), turned(turn, levels, parameters);
  double speed = 0, difference = 0;
  for_each_valid_cell(straight.grid, [&](std::size_t l, int, int i, int j, int k) {
    const Int3 at = turn(Int3{i, j, k});
    for (int c = 0; c < 3; ++c) {
      const double u = straight.fluid.u()[l](0, c)(i, j, k);
      speed = max_or_nan(speed, std::abs(u));
      difference = max_or_nan(difference, std::abs(turned.fluid.u()[l](0, turn(c))(at[0], at[1], at[2]) - u));
    }
  });
  EXPECT_GT(speed, 1.0);
  EXPECT_LT(difference, 1e-9 * speed) << "turned by " << by << " on " << levels << " levels";

  EXPECT_GT(std::abs(straight.flow[0]), 0.1);
  const std::vector<double> kinetic = straight.fluid.kinetic_outflow(),
                            turned_kinetic = turned.fluid.kinetic_outflow();
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_NEAR(turned.flow[m], straight.flow[m], 1e-9 * std::abs(straight.flow[m]));
    EXPECT_NEAR(turned_kinetic[m], kinetic[m], 1e-9 * std::abs(kinetic[m]));
    for (Eigen::Index n = 0; n < 2; ++n) {
      const auto k = static_cast<Eigen::Index>(m);
      EXPECT_NEAR(turned.fluid.modes().conductance()(k, n) / straight.fluid.modes().conductance()(k, n), 1,
                  1e-8);
    }
  }
  EXPECT_NEAR(straight.flow[0] + straight.flow[1], 0, 1e-8 * std::abs(straight.flow[0]));

  const Vec3 middle{0.8, 1.3, 0.5}, inlet{0.9, 1.6, 0};
  const auto through = [&](const Flow& f, const Turn& t, const Vec3& centre) {
    return flow_through_disc(f.grid, f.fluid.u(), t(2), t(centre), 0.5);
  };
  EXPECT_NEAR(through(straight, {0}, inlet), -straight.corrected[0], 1e-9 * std::abs(straight.corrected[0]));
  for (const Vec3& centre : {middle, inlet}) {
    const double flow = through(straight, {0}, centre);
    EXPECT_NEAR(through(turned, turn, centre), flow, 1e-9 * std::abs(flow));
  }
  const std::vector<Vec3> points{{0.3, 0.4, 0.9}, {1.6, 2.2, 3.3}};
  const std::vector<double> p = pressure_at(straight.grid, straight.fluid.p(), points);
  const std::vector<double> turned_p =
      pressure_at(turned.grid, turned.fluid.p(), {turn(points[0]), turn(points[1])});
  for (std::size_t m = 0; m < points.size(); ++m) EXPECT_NEAR(turned_p[m], p[m], 1e-7 * std::abs(p[m]));
}

TEST(Openings, OnTheSidesAlongXAndYGiveTheTurnedFlow)
{
  for (const int levels : {1, 2})
    for (const int by : {1, 2}) expect_turned_flow(by, levels, {1.06, 0.04});
}

TEST(Openings, OnTheSidesAlongXAndYGiveTheTurnedFlowWithImplicitViscosity)
{
  for (const int by : {1, 2})
    expect_turned_flow(by, 2, {1.06, 0.04, Advection::limited, 0, ViscosityScheme::crank_nicolson});
}

}  // namespace
}  // namespace valsalva::ib3d
