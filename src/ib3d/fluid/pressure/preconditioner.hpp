// What flexible CG needs of a preconditioner of the pressure problem: z ~ A^{-1} r on all levels, A as in
// composite_pressure.hpp.
#pragma once

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// z = approximate solution of A z = r; r is zero on covered cells, z is left with any value there and in its
  /// ghosts. Collective.
  virtual void apply(const CompositeCells<float>& r, CompositeCells<float>& z) = 0;
};

}  // namespace valsalva::ib3d
