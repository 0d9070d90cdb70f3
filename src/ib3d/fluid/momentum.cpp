#include "ib3d/fluid/momentum.hpp"

#include <cmath>
#include <limits>

#include "ib3d/fluid/advection.hpp"
#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

MomentumWeights weights_of(const Level& level, const FluidParameters& fluid, double dt, double w1)
{
  const double diffusion = fluid.viscosity / (fluid.density * level.h * level.h);
  const bool half = fluid.viscosity_scheme == ViscosityScheme::crank_nicolson;
  return {-1 / level.h, half ? 0.0 : diffusion, dt * (1 - w1), dt * w1, half ? 0.5 * dt * diffusion : 0.0};
}

}  // namespace

void Rates::renew()
{
  if (of_now) return;
  std::swap(last, before);
  gap = age;
  age = 0;
  of_now = true;
}

void Rates::accept(double dt)
{
  age += dt;
  of_now = false;
}

void advance_momentum(const Level& level, const FluidParameters& fluid, const MacField& u, const MacField* f,
                      double dt, double w1, MacField& rate, const MacField& rate_before, MacField& u_star)
{
  const MomentumWeights weights = weights_of(level, fluid, dt, w1);
  const double force = dt / fluid.density;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c) {
      const IndexBox box = faces_of(level.local_box(p), c);
      const std::ptrdiff_t sy = u(p, c).stride(1), sz = u(p, c).stride(2);
      const auto advance = [&](int j, int k, const double* div) {
        const int i = box.lo[0];
        double* out = u_star(p, c).at(i, j, k);
        momentum_row(out, rate(p, c).at(i, j, k), rate_before(p, c).at(i, j, k), u(p, c).at(i, j, k), div,
                     weights, sy, sz, box.size(0));
        if (f != nullptr) add_row(out, (*f)(p, c).at(i, j, k), force, box.size(0));
      };
      for_each_convected_row(fluid.advection, {&u(p, 0), &u(p, 1), &u(p, 2)}, c, box, advance);
    }
}

void advance_momentum_kept(const Level& level, const FluidParameters& fluid, const MacField& u,
                           const MacField* f, double dt, double w1, const MacField& rate,
                           const MacField& rate_before, MacField& u_star)
{
  const MomentumWeights weights = weights_of(level, fluid, dt, w1);
  const double force = dt / fluid.density;
  for_each_face_row(level, [&](int p, int c, int i, int j, int k, int n) {
    double* out = u_star(p, c).at(i, j, k);
    kept_momentum_row(out, rate(p, c).at(i, j, k), rate_before(p, c).at(i, j, k), u(p, c).at(i, j, k),
                      weights, u(p, c).stride(1), u(p, c).stride(2), n);
    if (f != nullptr) add_row(out, (*f)(p, c).at(i, j, k), force, n);
  });
}

double viscous_step_limit(const Level& level, const FluidParameters& fluid)
{
  if (fluid.viscosity_scheme == ViscosityScheme::crank_nicolson)
    return std::numeric_limits<double>::infinity();
  return 0.5 * fluid.density * level.h * level.h / (6 * fluid.viscosity);
}

}  // namespace valsalva::ib3d
