// Numbers read off the fields and the structure while a run goes on. All collective; the same result on every
// rank.
#pragma once

#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Pressure (units of p) at the points (x, y, z_k), trilinear between cell centres (constant beyond the
/// outermost).
std::vector<double> pressure_at(const Hierarchy& grid, const CompositeCells<double>& p, double x, double y,
                                const std::vector<double>& z);

/// Volume flow (ml/s, towards +z) through the disc of radius r (cm) about (x, y) in the plane of faces
/// of the coarsest level nearest to z.
double flow_through_disc(const Hierarchy& grid, const CompositeMac& u, double x, double y, double z,
                         double r);

/// Area (cm^2) inside the closed curve of the leaflets' free edges, seen along z; 0 when they overlap, NaN if a position is.
/// `edges` are the nodes' positions, leaflet after leaflet, each from commissure to commissure.
double orifice_area(const std::vector<Vec3>& edges);

}  // namespace valsalva::ib3d
