// Where the values of an array sit: on the faces normal to x, y, z, which is where the components 0, 1, 2 of a velocity
// are, or in the cells. Face index i is the low face of cell i.
#pragma once

#include "ib3d/grid/index_box.hpp"

namespace valsalva::ib3d {

enum class Centring { x_face, y_face, z_face, cell };

/// Of component d of a velocity.
constexpr Centring face_normal_to(int d)
{
  return static_cast<Centring>(d);
}
/// Whether direction d is normal to the faces; no direction is normal to cells.
constexpr bool is_normal(Centring c, int d)
{
  return c == face_normal_to(d);
}

/// All faces normal to d of the cells of a box, the high ones included.
inline IndexBox faces_of(const IndexBox& cells, int d)
{
  return cells.extended(kSides[static_cast<std::size_t>(2 * d + 1)], 1);
}
/// All values of the cells of a box: the cells or the faces.
inline IndexBox indices_of(const IndexBox& cells, Centring c)
{
  return c == Centring::cell ? cells : faces_of(cells, static_cast<int>(c));
}

}  // namespace valsalva::ib3d
