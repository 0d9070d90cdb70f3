// Domains that several tests of the fluid solver share.
#pragma once

#include "ib3d/fluid/pressure/openings.hpp"

namespace valsalva::ib3d {

/// A box whose two z sides are one opening each (radius beyond the corners): a straight tube of square
/// section.
inline std::vector<Opening> both_ends(const Vec3& size)
{
  const Vec3 centre{0.5 * size[0], 0.5 * size[1], 0};
  return {{"inlet", Side::z_lo, centre, 10 * size[0], "lv"},
          {"outlet", Side::z_hi, centre, 10 * size[0], "ao"}};
}

inline Domain walled_box(const Vec3& size)
{
  return {size,
          {SideKind::wall, SideKind::wall, SideKind::wall, SideKind::wall, SideKind::wall, SideKind::wall}};
}

inline Domain periodic_box(const Vec3& size)
{
  Domain d{size, {}};
  d.sides.fill(SideKind::periodic);
  return d;
}

}  // namespace valsalva::ib3d
