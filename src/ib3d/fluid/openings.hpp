// Openings: discs on a z side of the domain where the pressure is prescribed (normal traction, no tangential
// slip), and the pressure condition of every side of the domain.
//   wall           dp/dn = 0               theta = 0
//   open, disc     p = p_b on the side     theta = 1
// With one ghost layer, ghost = (1 - 2 theta) p_1 + 2 theta p_b, for p_1 the first cell inside.
// Flow Q (ml/s) is positive out of the 3D domain, into the opening's port of the 0D network.
#pragma once

#include <string>
#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

struct Opening {
  std::string name;
  int side = 4;       ///< 4 = z_lo, 5 = z_hi
  Vec3 center{};      ///< cm; the z component is ignored
  double radius = 0;  ///< cm
  std::string port;   ///< node of the 0D network
};

/// A plane of values over the first layer of cells of a patch along one side; t1, t2 the tangential
/// directions.
template <class T>
struct SidePlane {
  int side = 0;
  int t1 = 1, t2 = 2;
  int lo1 = 0, lo2 = 0, n1 = 0, n2 = 0;  ///< indices of the cells covered, ghosts left out
  std::vector<T> value;
  SidePlane() = default;
  SidePlane(const IndexBox& cells, int side_number, T fill);
  T& operator()(int a, int b) { return value[index(a, b)]; }
  T operator()(int a, int b) const { return value[index(a, b)]; }
  /// Like operator(), with indices outside the plane clamped to it (for corner ghosts).
  T clamped(int a, int b) const;

 private:
  std::size_t index(int a, int b) const { return static_cast<std::size_t>((b - lo2) * n1 + (a - lo1)); }
};

/// Share theta of prescribed pressure on each boundary face of the patch: 0 wall, 1 disc or open side.
/// Only sides at the domain's boundary that are not periodic appear.
std::vector<SidePlane<float>> pressure_shares(const Level& level, int local_patch,
                                              const std::vector<Opening>& openings);

/// Whether boundary face (a, b) of the side lies in the opening's disc (by its centre).
bool in_disc(const Opening& opening, const Level& level, int a, int b);

/// Area (cm^2) of the faces that make up the opening's disc on this level.
double disc_area(const Opening& opening, const Level& level);

/// Volume flow (ml/s) through every opening, positive out of the domain. Collective.
std::vector<double> flow_through(const std::vector<Opening>& openings, const Level& level, const MacField& u);

}  // namespace valsalva::ib3d
