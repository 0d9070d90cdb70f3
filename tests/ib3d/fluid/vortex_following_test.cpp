// The grid follows vorticity: a vortex that the stream carries never reaches cells that are not refined.
#include "common/max_or_nan.hpp"
#include "ib3d/fluid/carried_vortex.hpp"
#include "ib3d/fluid/vorticity.hpp"

namespace valsalva::ib3d {
namespace {

constexpr double kThreshold = 0.5;  // 1/s, at 2.6 core radii

/// Largest |curl u| at the edges of coarse cells without finer ones over them.
double vorticity_not_refined(const NavierStokes& fluid)
{
  const CompositeMac& u = fluid.u();
  double largest = 0;
  for_each_valid_cell(fluid.grid(), [&](std::size_t l, int p, int i, int j, int k) {
    if (l > 0) return;
    const double dv = u[0](p, 1)(i, j, k) - u[0](p, 1)(i - 1, j, k),
                 du = u[0](p, 0)(i, j, k) - u[0](p, 0)(i, j - 1, k);
    largest = max_or_nan(largest, std::abs(dv - du) / kCoarse);
  });
  return largest;
}

TEST(Vorticity, AVortexThatTheFlowCarriesStaysOnTheFineLevel)
{
  const Domain domain = periodic_box(kVortexBox);
  RefinementPolicy policy;
  policy.levels = 2;
  policy.vorticity = kThreshold;
  const double h = kCoarse / 2, start = 6.1, distance = 2;
  const IndexBox middle{{32, 16, 0}, {112, 56, 8}};
  CarriedVortex vortex(Hierarchy(domain, h, MPI_COMM_SELF, Refinement{{middle}}), start, Advection::limited);
  const auto follow = [&] {
    const NavierStokes& now = *vortex.fluid;
    Refinement boxes = refine(domain, h, policy, {}, vortical_blocks(now.grid(), now.u(), kThreshold));
    vortex.move_to(Hierarchy(domain, h, MPI_COMM_SELF, boxes));
    return boxes;
  };
  follow();
  EXPECT_LT(vortex.fluid->grid().finest().cell_count(), 0.6 * static_cast<double>(middle.volume()));

  // As ImmersedBoundarySolver does: anew when the fastest fluid has moved by half a cell less than the margin.
  const double fastest = 2.2, dt = 0.3 * h / fastest;
  double moved = 0, largest = 0;
  std::vector<Refinement> grids;
  for (double x = 0; x < distance; x += kStream * dt) {
    vortex.step(dt);
    largest = max_or_nan(largest, vorticity_not_refined(*vortex.fluid));
    moved += fastest * dt / h;
    if (moved < policy.margin_cells - 0.5) continue;
    moved = 0;
    const Refinement boxes = follow();
    if (grids.empty() || boxes != grids.back()) grids.push_back(boxes);
  }
  RecordProperty("largest vorticity outside", fmt::format("{:.3f}, {} grids", largest, grids.size()));
  EXPECT_GE(grids.size(), 4U);
  EXPECT_LT(largest, kThreshold);
}

}  // namespace
}  // namespace valsalva::ib3d
