// A box of fluid that turns like a solid about the axis of the box at a rate that changes in time: the delta function
// interpolates it exactly, so that what markers do wrong in it is their stepping alone.
#pragma once

#include <cmath>

#include "ib3d/fluid/grids.hpp"
#include "ib3d/interaction/markers.hpp"

namespace valsalva::ib3d {

inline const Vec3 kTurningBox{2, 2, 4};
inline constexpr double kClimb = 0.3;  ///< cm/s along z

/// Angle (rad) turned by time t, and its rate.
inline double angle_at(double t)
{
  return 3 * t + 0.8 * (1 - std::cos(5 * t));
}
inline double rate_at(double t)
{
  return 3 + 4 * std::sin(5 * t);
}

/// The velocity at time t on all stored faces of all levels, ghosts too.
inline CompositeMac turning_flow(const Hierarchy& grid, double t)
{
  CompositeMac u = composite_faces(grid);
  for (std::size_t l = 0; l < u.size(); ++l)
    for (int p = 0; p < u[l].patch_count(); ++p)
      for (int c = 0; c < 3; ++c) {
        const double h = grid.levels()[l].h;
        for_each_index(u[l](p, c).stored(), [&](int i, int j, int k) {
          const double x = (i + (c == 0 ? 0.0 : 0.5)) * h - 1, y = (j + (c == 1 ? 0.0 : 0.5)) * h - 1;
          u[l](p, c)(i, j, k) = c == 0 ? -rate_at(t) * y : c == 1 ? rate_at(t) * x : kClimb;
        });
      }
  return u;
}

/// Where a point from X at t = 0 is at time t.
inline Vec3 turned(const Vec3& X, double t)
{
  const double a = angle_at(t), x = X[0] - 1, y = X[1] - 1;
  return {1 + x * std::cos(a) - y * std::sin(a), 1 + x * std::sin(a) + y * std::cos(a), X[2] + kClimb * t};
}

inline std::vector<Vec3> points_about_the_axis()
{
  std::vector<Vec3> points;
  for (int n = 0; n < 40; ++n)
    points.push_back({1 + 0.02 * n * std::cos(0.7 * n), 1 + 0.017 * n * std::sin(0.7 * n), 0.4 + 0.06 * n});
  return points;
}

/// Moves the markers from t = 0 over `steps` steps to the time `end`.
inline void turn(Markers& markers, const Hierarchy& grid, int steps, double end)
{
  const double dt = end / steps;
  markers.seed_due(grid, turning_flow(grid, 0), 0);
  for (int n = 0; n < steps; ++n) markers.advance(grid, turning_flow(grid, (n + 1) * dt), dt);
}

}  // namespace valsalva::ib3d
