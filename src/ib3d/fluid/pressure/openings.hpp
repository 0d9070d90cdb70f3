// Openings: discs on the sides of the domain where the pressure is prescribed (normal traction, no tangential
// slip), and the pressure condition of every side of the domain.
//   wall           dp/dn = 0               theta = 0
//   open, disc     p = p_b on the side     theta = 1
// With one ghost layer, ghost = (1 - 2 theta) p_1 + 2 theta p_b, for p_1 the first cell inside.
// Flow Q (ml/s) is positive out of the 3D domain, into the opening's port of the 0D network.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// A disc on a side of the domain.
struct Opening {
  std::string name;
  Side side = Side::z_lo;
  Vec3 centre{};      ///< cm; the component across the side is ignored
  double radius = 0;  ///< cm
  std::string port;   ///< node of the 0D network
};

/// Indices of a place on a side: `along` across it, a and b along its tangents.
constexpr Int3 place_at(Side side, int along, int a, int b)
{
  Int3 at{};
  at[static_cast<std::size_t>(axis(side))] = along;
  at[static_cast<std::size_t>(first_tangent(side))] = a;
  at[static_cast<std::size_t>(second_tangent(side))] = b;
  return at;
}

/// A plane of values over the first layer of cells of a patch along one side, indexed along its two tangents.
template <class T>
struct SidePlane {
  Side side = Side::x_lo;
  int lo1 = 0, lo2 = 0, n1 = 0, n2 = 0;  ///< indices of the cells covered, without ghosts
  std::vector<T> value;
  SidePlane() = default;
  /// Over the cells of a patch that touches the side, every value `fill`.
  SidePlane(const IndexBox& cells, Side at, T fill)
      : side(at),
        lo1(cells.lo[static_cast<std::size_t>(first_tangent(at))]),
        lo2(cells.lo[static_cast<std::size_t>(second_tangent(at))]),
        n1(cells.size(first_tangent(at))),
        n2(cells.size(second_tangent(at))),
        value(static_cast<std::size_t>(n1) * static_cast<std::size_t>(n2), fill)
  {
  }
  T& operator()(int a, int b) { return value[index(a, b)]; }
  T operator()(int a, int b) const { return value[index(a, b)]; }
  /// Calls f(address in `array` of the first place, number of its value) for every row of n1 places along the first
  /// tangent, with `along` as their index across the side.
  template <class U, class F>
  void for_each_row(Array3<U>& array, int along, F&& f) const
  {
    const Int3 at = place_at(side, along, lo1, lo2);
    U* place = array.at(at[0], at[1], at[2]);
    for (int b = 0; b < n2; ++b)
      f(place + b * array.stride(second_tangent(side)),
        static_cast<std::size_t>(b) * static_cast<std::size_t>(n1));
  }
  /// Calls f(place, a, b) for every place, one by one: for what is built once.
  template <class F>
  void for_each(int along, F&& f) const
  {
    for (int b = lo2; b < lo2 + n2; ++b)
      for (int a = lo1; a < lo1 + n1; ++a) f(place_at(side, along, a, b), a, b);
  }
  /// Like operator(), with indices outside the plane clamped to it (for corner ghosts).
  T clamped(int a, int b) const
  {
    return (*this)(std::clamp(a, lo1, lo1 + n1 - 1), std::clamp(b, lo2, lo2 + n2 - 1));
  }

 private:
  std::size_t index(int a, int b) const { return static_cast<std::size_t>((b - lo2) * n1 + (a - lo1)); }
};

/// Whether boundary face (a, b) of the side lies in the opening's disc (by its centre).
bool in_disc(const Opening& opening, const Level& level, int a, int b);

/// theta of a face from the sum of those of the four finer ones under it: 1.25 x their mean, at most 1, so that a small
/// disc does not vanish (measured in the project's design).
constexpr float coarse_share(float sum_of_four)
{
  return std::min(1.0f, 1.25f * 0.25f * sum_of_four);
}

/// Share theta of prescribed pressure on each boundary face of a local patch of level l: 0 wall, 1 disc or open
/// side, `coarse_share` under finer faces.
/// Only sides at the domain's boundary that are not periodic appear.
std::vector<SidePlane<float>> pressure_shares(const Hierarchy& grid, int l, int local_patch,
                                              const std::vector<Opening>& openings);

/// The boundary faces of this rank that make up the openings' discs, none of them under a finer level.
class OpeningFaces {
 public:
  struct Face {
    int level, patch;  ///< patch: local number
    Side side;
    Int3 at;     ///< of the face
    Int3 below;  ///< of the cell on its low side; `at` is that on its high side

    /// The velocity through it, along its axis.
    double normal(const CompositeMac& u) const
    {
      return u[static_cast<std::size_t>(level)](patch, axis(side))(at[0], at[1], at[2]);
    }
    /// The jump of cell values across it, along its axis.
    template <class T>
    T jump(const CompositeCells<T>& p) const
    {
      const Array3<T>& a = p[static_cast<std::size_t>(level)][patch];
      return a(at[0], at[1], at[2]) - a(below[0], below[1], below[2]);
    }
  };
  /// CaseError("opening.radius_cm") names a disc without any face. Collective.
  OpeningFaces(const Hierarchy& grid, const std::vector<Opening>& openings);

  int count() const { return static_cast<int>(faces_.size()); }
  const std::vector<Face>& of(std::size_t opening) const { return faces_[opening]; }
  /// cm^2.
  double area(std::size_t opening) const { return area_[opening]; }
  /// Volume flow (ml/s) through every opening, positive out of the domain, for the velocity (cm/s) that w(face)
  /// gives along the face's axis. Collective.
  template <class W>
  std::vector<double> flow_of(W&& w) const;
  /// The same of a velocity field (cm/s).
  std::vector<double> flow(const CompositeMac& u) const
  {
    return flow_of([&](const Face& f) { return f.normal(u); });
  }

 private:
  MPI_Comm comm_;
  std::vector<double> h_;  ///< of every level
  std::vector<double> area_;
  std::vector<std::vector<Face>> faces_;
};

template <class W>
std::vector<double> OpeningFaces::flow_of(W&& w) const
{
  std::vector<double> flow(faces_.size(), 0.0);
  for (std::size_t m = 0; m < faces_.size(); ++m)
    for (const Face& f : faces_[m]) {
      const double h = h_[static_cast<std::size_t>(f.level)];
      flow[m] += -inward(f.side) * h * h * w(f);
    }
  MPI_Allreduce(MPI_IN_PLACE, flow.data(), static_cast<int>(flow.size()), MPI_DOUBLE, MPI_SUM, comm_);
  return flow;
}

}  // namespace valsalva::ib3d
