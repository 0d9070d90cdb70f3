// The last act of a step: the pressure puts the divergence right,
//     p += sum_k phi_k psi_k,    u -= (dt/rho) grad p          (docs/scheme.md, 3.2)
// One plane of cells after the other, so that every value passes through the cache once: at a few hundred thousand cells
// all these passes wait for memory.
// p dyn/cm^2 with all ghosts filled, u cm/s on all faces of the local patches.
#pragma once

#include "ib3d/fluid/opening_modes.hpp"

namespace valsalva::ib3d {

/// u -= time_over_density grad p on one level (cm^3 s/g). Local to the rank.
void subtract_gradient(const Level& level, double time_over_density, const CellField<double>& p, MacField& u);

/// The same on all levels after phi (dyn/cm^2, one per opening) has been added by superposition. Returns the Courant rate
/// of the finest level (1/s; courant_rate.hpp), found on the way. Local to the rank.
double correct_velocity(const Hierarchy& grid, const OpeningModes& modes, const std::vector<double>& phi,
                        double time_over_density, CompositeCells<double>& p, CompositeMac& u);

}  // namespace valsalva::ib3d
