// Numbers read off the fields and the structure during a run. All collective; the same result on every
// rank.
#pragma once

#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Pressure (units of p) at points (cm), trilinear between cell centres, constant beyond the outermost.
std::vector<double> pressure_at(const Hierarchy& grid, const CompositeCells<double>& p,
                                const std::vector<Vec3>& points);

/// Volume flow (ml/s, positive along direction d) through the disc of this centre and radius (cm) across d, in the plane of
/// faces of the coarsest level nearest to the centre.
double flow_through_disc(const Hierarchy& grid, const CompositeMac& u, int d, const Vec3& centre, double r);

/// Area (cm^2) inside the closed curve of the leaflets' free edges, seen along z; 0 when they overlap, NaN if a position is.
/// `edges` are the nodes' positions, leaflet after leaflet, each from commissure to commissure.
double orifice_area(const std::vector<Vec3>& edges);

}  // namespace valsalva::ib3d
