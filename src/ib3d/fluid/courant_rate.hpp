// The CFL number per unit of time: the largest over the cells of (|u| + |v| + |w|)/h, with the larger of the two faces in
// each direction. cm/s -> 1/s; infinite where a velocity is not finite. Local to the rank.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Over the cells of a local patch with index k along z.
double courant_rate(const Level& level, const MacField& u, int patch, int k);
/// Over all cells of the local patches.
double courant_rate(const Level& level, const MacField& u);

}  // namespace valsalva::ib3d
