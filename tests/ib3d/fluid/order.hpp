// Observed order of the fluid solver on flows known in closed form: error norms on a sequence of grids whose
// step shrinks with the spacing. Velocity is compared at the end, pressure half a step before it, where it is
// of second order (its mean removed where no side fixes it).
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "ib3d/fluid/grids.hpp"
#include "ib3d/fluid/navier_stokes.hpp"

namespace valsalva::ib3d {

struct ExactFlow {
  std::function<Domain(double h)> domain;
  double length = 1;  ///< cm: n cells cover it
  FluidParameters fluid;
  std::function<double(int c, const Vec3&x, double t)> velocity, force;
  std::function<double(const Vec3& x, double t)> pressure;
  double end_s = 0.25, dt_per_h = 0.1;
  int levels = 1;  ///< n cells count on level 0; the middle is refined
  int steps_of_one_convection = 1;
};

struct ErrorNorms {
  double l1 = 0, l2 = 0;
};

struct FlowErrors {
  ErrorNorms velocity, pressure;
};

/// Sets the component c of every face of the local patches, their high faces included.
inline void fill_faces(const Level& level, MacField& u, const std::function<double(int, const Vec3&)>& value)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_index(faces_of(level.local_box(p), c), [&](int i, int j, int k) {
        Vec3 x{(i + 0.5) * level.h, (j + 0.5) * level.h, (k + 0.5) * level.h};
        x[c] -= 0.5 * level.h;
        u(p, c)(i, j, k) = value(c, x);
      });
}

inline ErrorNorms norms(const std::vector<double>& errors)
{
  ErrorNorms n;
  for (double e : errors) {
    n.l1 += std::abs(e) / static_cast<double>(errors.size());
    n.l2 += e * e / static_cast<double>(errors.size());
  }
  n.l2 = std::sqrt(n.l2);
  return n;
}

inline FlowErrors flow_errors(const ExactFlow& flow, int n)
{
  const double h = flow.length / n;
  const Domain domain = flow.domain(h);
  const Hierarchy grid = nested_grid(domain, h, flow.levels, true);
  NavierStokes fluid(grid, {}, flow.fluid, {"multilevel", 1e-8, 100});
  CompositeMac field = composite_faces(grid);
  const auto fill = [&](const auto& value, double t) {
    for (std::size_t l = 0; l < field.size(); ++l)
      fill_faces(grid.levels()[l], field[l], [&](int c, const Vec3& x) { return value(c, x, t); });
  };
  const long steps = std::lround(flow.end_s / (flow.dt_per_h * grid.finest().h));
  const double dt = flow.end_s / static_cast<double>(steps);
  fill(flow.velocity, 0);
  fluid.set_velocity(field);
  for (long step = 0; step < steps; ++step) {
    fill(flow.force, (static_cast<double>(step) + 0.5) * dt);
    fluid.begin_step(field, dt, step % flow.steps_of_one_convection != 0);
    fluid.solve_pressure({});
    fluid.finish_step({});
  }

  fill(flow.velocity, flow.end_s);
  std::vector<double> u, p;
  double mean = 0;
  for (int l = 0; l < grid.level_count(); ++l)
    for (int c = 0; c < 3; ++c)
      for_each_owned_face(grid.level(l), 0, c, [&](int i, int j, int k) {
        const auto ll = static_cast<std::size_t>(l);
        if (!grid.covered(l, {i, j, k})) u.push_back(fluid.u()[ll](0, c)(i, j, k) - field[ll](0, c)(i, j, k));
      });
  for_each_valid_cell(grid, [&](std::size_t l, int q, int i, int j, int k) {
    const double hl = grid.levels()[l].h;
    p.push_back(fluid.p()[l][q](i, j, k) -
                flow.pressure({(i + 0.5) * hl, (j + 0.5) * hl, (k + 0.5) * hl}, flow.end_s - 0.5 * dt));
    mean += p.back();
  });
  mean /= static_cast<double>(p.size());
  bool fixed = false;
  for (SideKind side : domain.sides) fixed = fixed || side == SideKind::open;
  if (!fixed)
    for (double& e : p) e -= mean;
  return {norms(u), norms(p)};
}

struct Orders {
  ErrorNorms velocity, pressure;
};

/// log2 of the error ratio between n and 2n cells.
inline Orders observed_orders(const ExactFlow& flow, int n)
{
  const FlowErrors coarse = flow_errors(flow, n), fine = flow_errors(flow, 2 * n);
  const auto order = [](double a, double b) { return std::log2(a / b); };
  return {{order(coarse.velocity.l1, fine.velocity.l1), order(coarse.velocity.l2, fine.velocity.l2)},
          {order(coarse.pressure.l1, fine.pressure.l1), order(coarse.pressure.l2, fine.pressure.l2)}};
}

/// The choices of the fluid solver that the orders are tested for.
struct Scheme {
  Advection advection;
  ViscosityScheme viscosity;
  const char* name;
};
inline constexpr Scheme kSchemes[] = {
    {Advection::limited, ViscosityScheme::explicit_, "limited flux, explicit viscosity"},
    {Advection::xsppm7, ViscosityScheme::explicit_, "xsPPM7, explicit viscosity"},
    {Advection::xsppm7, ViscosityScheme::crank_nicolson, "xsPPM7, Crank-Nicolson"},
};
inline constexpr Scheme kStokesSchemes[] = {
    {Advection::none, ViscosityScheme::explicit_, "no flux, explicit viscosity"},
    {Advection::none, ViscosityScheme::crank_nicolson, "no flux, Crank-Nicolson"},
};

/// Velocity of at least this order, pressure of order 1.5, between n and 2n cells.
inline void expect_second_order(ExactFlow flow, const Scheme& scheme, int n, double velocity_order = 1.8)
{
  flow.fluid.advection = scheme.advection;
  flow.fluid.viscosity_scheme = scheme.viscosity;
  const std::string place = fmt::format("{}, {} cells, {} levels", scheme.name, n, flow.levels);
  const Orders order = observed_orders(flow, n);
  ::testing::Test::RecordProperty(
      place, fmt::format("velocity {:.3f} {:.3f} pressure {:.3f} {:.3f}", order.velocity.l1,
                         order.velocity.l2, order.pressure.l1, order.pressure.l2));
  EXPECT_GT(order.velocity.l1, velocity_order) << place;
  EXPECT_GT(order.velocity.l2, velocity_order) << place;
  EXPECT_GT(order.pressure.l1, 1.5) << place;
  EXPECT_GT(order.pressure.l2, 1.5) << place;
}

}  // namespace valsalva::ib3d
