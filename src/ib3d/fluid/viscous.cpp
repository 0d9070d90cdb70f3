#include "ib3d/fluid/viscous.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/error.hpp"
#include "ib3d/fluid/pressure/composite_pressure.hpp"
#include "ib3d/grid/row_kernels.hpp"

namespace valsalva::ib3d {

namespace {

constexpr double kRelativeChange = 1e-9;
constexpr int kMaxSweeps = 500;

}  // namespace

ViscousSolver::ViscousSolver(const Hierarchy& grid)
    : grid_(grid), b_(composite_faces(grid)), before_(composite_faces(grid))
{
}

int ViscousSolver::solve(double diffusion, const CompositeMac& guess, CompositeMac& u,
                         const std::function<void(CompositeMac&)>& complete)
{
  std::swap(b_, u);
  const CompositeMac* from = &guess;
  for (int sweeps = 1; sweeps <= kMaxSweeps; ++sweeps) {
    sweep(diffusion, *from, u);
    complete(u);
    const double change = relative_change(*from, u);
    if (change <= kRelativeChange) return sweeps;
    if (!std::isfinite(change)) throw SolverError("the viscous solve met a number that is not finite");
    std::swap(before_, u);
    from = &before_;
  }
  throw SolverError(fmt::format(
      "the viscous solve has not converged after {} sweeps; a smaller time.dt_max_s makes it easier",
      kMaxSweeps));
}

void ViscousSolver::sweep(double diffusion, const CompositeMac& from, CompositeMac& to) const
{
  for (std::size_t l = 0; l < to.size(); ++l) {
    const Level& level = grid_.levels()[l];
    const double a = diffusion / (level.h * level.h);
    for_each_face_row(level, [&](int p, int c, int i, int j, int k, int n) {
      const Array3<double>& q = from[l](p, c);
      jacobi_row(to[l](p, c).at(i, j, k), b_[l](p, c).at(i, j, k), q.at(i, j, k), a, q.stride(1), q.stride(2),
                 n);
    });
  }
}

double ViscousSolver::relative_change(const CompositeMac& a, const CompositeMac& b) const
{
  double largest[2] = {0, 0};  // change, value
  for (int c = 0; c < 3; ++c)
    for_each_local_row(grid_, [&](std::size_t l, int p, int i, int j, int k, int n) {
      compare_row(a[l](p, c).at(i, j, k), b[l](p, c).at(i, j, k), largest, n);
    });
  MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, grid_.comm());
  return largest[1] > 0 || std::isinf(largest[0]) ? largest[0] / largest[1] : 0.0;
}

}  // namespace valsalva::ib3d
