// Observed order of the fluid solver on flows known in closed form: error norms on a sequence of grids whose
// step shrinks with the spacing. Velocity is compared at the end, pressure half a step before it, where it is
// of second order (its mean removed where no side fixes it).
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "ib3d/fluid/navier_stokes.hpp"

namespace valsalva::ib3d {

struct ExactFlow {
  std::function<Domain(double h)> domain;
  double length = 1;  ///< cm: n cells cover it
  FluidParameters fluid;
  std::function<double(int c, const Vec3&x, double t)> velocity, force;
  std::function<double(const Vec3& x, double t)> pressure;
  double end_s = 0.25, dt_per_h = 0.1;
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
  const Hierarchy grid(domain, h, MPI_COMM_SELF);
  const Level& level = grid.finest();
  NavierStokes fluid(grid, {}, flow.fluid, {"multilevel", 1e-8, 100});
  MacField field(level);
  const long steps = std::lround(flow.end_s / (flow.dt_per_h * h));
  const double dt = flow.end_s / static_cast<double>(steps);
  fill_faces(level, field, [&](int c, const Vec3& x) { return flow.velocity(c, x, 0); });
  fluid.set_velocity({field});
  for (long step = 0; step < steps; ++step) {
    const double middle = (static_cast<double>(step) + 0.5) * dt;
    fill_faces(level, field, [&](int c, const Vec3& x) { return flow.force(c, x, middle); });
    fluid.begin_step(field, dt);
    fluid.solve_pressure({});
    fluid.finish_step({});
  }

  fill_faces(level, field, [&](int c, const Vec3& x) { return flow.velocity(c, x, flow.end_s); });
  std::vector<double> u, p;
  double mean = 0;
  const IndexBox& box = level.local_box(0);
  for (int c = 0; c < 3; ++c)
    for_each_owned_face(level, 0, c, [&](int i, int j, int k) {
      u.push_back(fluid.u()[0](0, c)(i, j, k) - field(0, c)(i, j, k));
    });
  for_each_index(box, [&](int i, int j, int k) {
    p.push_back(fluid.p()[0][0](i, j, k) -
                flow.pressure({(i + 0.5) * h, (j + 0.5) * h, (k + 0.5) * h}, flow.end_s - 0.5 * dt));
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

}  // namespace valsalva::ib3d
