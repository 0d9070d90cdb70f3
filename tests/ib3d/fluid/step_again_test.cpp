// A step can be given up: begun with another dt, force and pressures and then begun again, it ends as if it had never been
// tried otherwise, to the last bit, and so do the steps that follow.
#include <gtest/gtest.h>

#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {
namespace {

CompositeMac rough_field(const Hierarchy& grid, double phase)
{
  CompositeMac f = composite_faces(grid);
  for (std::size_t l = 0; l < f.size(); ++l)
    fill_faces(grid.levels()[l], f[l], [&](int c, const Vec3& x) {
      return 6 * std::sin(5 * x[0] - 3 * x[1] + 2 * x[2] + c + phase);
    });
  return f;
}

enum class Tried { nothing, velocity, velocity_and_pressure };

struct Flow {
  Flow(const FluidParameters& fluid, int levels)
      : grid(nested_grid(walled_box({1, 1, 2}), 1.0 / 16, levels, true)),
        flow(grid, both_ends({1, 1, 2}), fluid, {"multilevel", 1e-6, 100})
  {
    flow.set_velocity(rough_field(grid, 0.3));
  }
  /// Steps of uneven length; the rates are kept in those whose number is no multiple of `steps_of_one_convection`.
  void advance(Tried tried, int steps_of_one_convection)
  {
    for (int step = 0; step < 7; ++step) {
      const bool keep = step % steps_of_one_convection != 0;
      if (tried != Tried::nothing) flow.begin_step(rough_field(grid, 9.0 * step), 3e-3, keep);
      if (tried == Tried::velocity_and_pressure) flow.solve_pressure({-300, 700});
      flow.begin_step(rough_field(grid, step), 1e-3 * (1 + 0.1 * (step % 3)), keep);
      outflow = flow.solve_pressure({500, 100});
      flow.finish_step({10, -5});
    }
  }
  Hierarchy grid;
  NavierStokes flow;
  std::vector<double> outflow;
};

void expect_no_trace(const FluidParameters& fluid, int levels, int steps_of_one_convection)
{
  Flow straight(fluid, levels);
  straight.advance(Tried::nothing, steps_of_one_convection);
  EXPECT_GT(straight.flow.courant_rate(), 1.0);
  for (const Tried tried : {Tried::velocity, Tried::velocity_and_pressure}) {
    Flow again(fluid, levels);
    again.advance(tried, steps_of_one_convection);
    EXPECT_EQ(again.outflow, straight.outflow);
    for (std::size_t l = 0; l < straight.flow.u().size(); ++l) {
      EXPECT_EQ(again.flow.p()[l][0].data(), straight.flow.p()[l][0].data());
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(again.flow.u()[l](0, c).data(), straight.flow.u()[l](0, c).data()) << levels << " levels";
    }
  }
}

TEST(NavierStokes, AStepThatIsGivenUpLeavesNoTrace)
{
  for (const Scheme& scheme : kSchemes)
    for (const int levels : {1, 2})
      for (const int steps_of_one_convection : {1, 3}) {
        SCOPED_TRACE(scheme.name);
        expect_no_trace({1.06, 0.04, scheme.advection, 0, scheme.viscosity}, levels, steps_of_one_convection);
      }
}

}  // namespace
}  // namespace valsalva::ib3d
