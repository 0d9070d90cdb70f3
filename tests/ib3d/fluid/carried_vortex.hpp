// An isolated vortex (no circulation: nothing but the stream a few radii away),
//     u = U - y w,  v = x w,  w = exp((1 - r^2/s^2)/2)/s,   x, y from its centre, largest swirl 1 at r = s,
// carried along x. It is a steady solution of Euler's equations in its own frame. cm, s.
#pragma once

#include "ib3d/fluid/order.hpp"

namespace valsalva::ib3d {

inline constexpr double kStream = 1.0, kCore = 0.5, kCoarse = 1.0 / 6;
inline const Vec3 kVortexBox{16, 6, 4 * kCoarse};

inline double vortex_velocity(int c, const Vec3& x, double centre)
{
  const double dx = x[0] - centre, dy = x[1] - 0.5 * kVortexBox[1];
  const double w = std::exp(0.5 * (1 - (dx * dx + dy * dy) / (kCore * kCore))) / kCore;
  return c == 0 ? kStream - dy * w : c == 1 ? dx * w : 0.0;
}

/// Fluid of hardly any viscosity that holds nothing but the vortex.
struct CarriedVortex {
  CarriedVortex(const Hierarchy& start, double centre, Advection advection)
      : grid(std::make_unique<Hierarchy>(start)),
        fluid(std::make_unique<NavierStokes>(*grid, std::vector<Opening>{},
                                             FluidParameters{1.0, 1e-4, advection},
                                             PressureOptions{"multilevel", 1e-7, 100}))
  {
    CompositeMac u = composite_faces(*grid);
    for (std::size_t l = 0; l < u.size(); ++l)
      fill_faces(grid->levels()[l], u[l],
                 [&](int c, const Vec3& x) { return vortex_velocity(c, x, centre); });
    fluid->set_velocity(u);
  }

  void move_to(const Hierarchy& next)
  {
    auto there = std::make_unique<Hierarchy>(next);
    fluid = std::make_unique<NavierStokes>(*there, *fluid);
    grid = std::move(there);
  }

  void step(double dt) const
  {
    fluid->begin_step(composite_faces(fluid->grid()), dt);
    fluid->solve_pressure({});
    fluid->finish_step({});
  }

  std::unique_ptr<Hierarchy> grid;
  std::unique_ptr<NavierStokes> fluid;
};

}  // namespace valsalva::ib3d
