// Fibre networks as text files in the format of IBAMR's structures: a count, then one line each (cm, dyn, s):
//   prefix.vertex  x y z                 the only file that must exist
//   prefix.spring  i j k l0 [type]       F = k (l - l0); type 0 two-sided, 1 tension-only
//   prefix.beam    i0 i1 i2 k [0 0 0]    F1 = 2 k (X2 - 2 X1 + X0), F0 = F2 = -F1/2
//   prefix.target  i kappa [0]           F = kappa (X(start) - X)
//   prefix.beam_lengths  l1 l2           of each beam; ours, optional, unknown to IBAMR
// Node numbers begin at 0; text after '#' or '//' is a comment. Conversions: spring stiffness = k l0, where
// l0 = 0 becomes 1e-9 cm; beam rigidity = k l^3, l1 = l2 = l the mean of its sides at the start, which gives
// IBAMR's force on any spacing (with .beam_lengths, l = (l1 + l2)/2 and the sides keep their lengths).
// Preferred curvature, target damping and other spring types are refused.
#pragma once

#include <string>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

/// Reads prefix.vertex, .spring, .beam, .target; one group named after the prefix's last part. IoError if a
/// file cannot be read, CaseError with file and line of the first problem of every file.
FibreNetwork read_fibre_files(const std::string& prefix);

/// Writes all files to full precision. Group names and free edges are not kept. IoError if a file cannot be
/// written or a tether's target is not the node's start, which the format cannot express.
void write_fibre_files(const FibreNetwork& network, const std::string& prefix);

}  // namespace valsalva::ib3d
