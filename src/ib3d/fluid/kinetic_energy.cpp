#include "ib3d/fluid/kinetic_energy.hpp"

namespace valsalva::ib3d {

double kinetic_energy(const Hierarchy& grid, const CompositeMac& u, double density)
{
  double energy = 0;
  for (int l = 0; l < grid.level_count(); ++l) {
    const Level& level = grid.level(l);
    const MacField& velocity = u[static_cast<std::size_t>(l)];
    double squares = 0;
    for (int p = 0; p < level.local_count(); ++p)
      for_each_index(level.local_box(p), [&](int i, int j, int k) {
        if (grid.covered(l, {i, j, k})) return;
        for (int d = 0; d < 3; ++d) {
          const Array3<double>& w = velocity(p, d);
          const double low = w(i, j, k), high = w(i + (d == 0), j + (d == 1), k + (d == 2));
          squares += low * low + high * high;
        }
      });
    energy += 0.25 * density * level.h * level.h * level.h * squares;
  }
  MPI_Allreduce(MPI_IN_PLACE, &energy, 1, MPI_DOUBLE, MPI_SUM, grid.comm());
  return energy;
}

}  // namespace valsalva::ib3d
