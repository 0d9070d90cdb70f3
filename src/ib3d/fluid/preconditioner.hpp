// What flexible CG needs of a preconditioner of the pressure problem: z ~ A^{-1} (scale r), with A = 6 - neighbours
// (no 1/h^2). scale r is O(1), so single precision inside is safe.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// z = approximate solution of A z = scale r; ghosts of r are not read, those of z are left undefined.
  /// Collective.
  virtual void apply(const CellField<double>& r, double scale, CellField<float>& z) = 0;
};

}  // namespace valsalva::ib3d
