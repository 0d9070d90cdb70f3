// Kinetic energy of the fluid on all levels:
//     sum over the cells that no finer level covers of (rho/2) h^3 sum_d (u_low^2 + u_high^2)/2
// with u_low, u_high the velocities (cm/s) on the two faces of the cell normal to d. Collective.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// erg, the same on all ranks; density in g/cm^3.
double kinetic_energy(const Hierarchy& grid, const CompositeMac& u, double density);

}  // namespace valsalva::ib3d
