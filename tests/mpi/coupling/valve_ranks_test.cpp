// The aortic root on a coarse grid: the same on any number of ranks, to rounding times the sharpness of the
// pressure solve; the same bit for bit when repeated on the same ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "common/max_or_nan.hpp"
#include "furthest_apart.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace valsalva::coupling {

using namespace setup;
namespace {

struct Outcome {
  std::vector<double> flow, pressure, states;
  std::vector<Vec3> X, markers;
};

/// `steps` steps of 1e-4 s with the ventricle's pressure rising at once, so that the valve begins to move.
Outcome run(MPI_Comm comm, int steps, const std::vector<std::string>& more = {})
{
  const auto root = std::filesystem::path(VALSALVA_SOURCE_DIR) / "cases/aortic_root/case.toml";
  std::vector<std::string> keys{
      "grid.finest_cm=0.2083333333", "time.dt_fixed_s=1e-4", "pressure.divergence_tolerance_1_s=1e-9",
      "element.ventricle.time_s=[0.0, 0.002, 0.15]", "element.ventricle.pressure_mmHg=[0.0, 20.0, 120.0]"};
  keys.insert(keys.end(), more.begin(), more.end());
  const Case c = read_case(root.string(), keys);
  Timers timers;
  CaseModel m(c, Communicator(comm), timers);
  for (int n = 0; n < steps; ++n) m.model().advance(m.model().next_step(1.0));
  const InterfaceState& end = m.model().interface();
  const ib3d::NodeDistribution& nodes = m.solver().nodes();
  std::vector<Vec3> markers;
  for (const ib3d::Marker& marker : m.solver().markers().gather(comm)) markers.push_back(marker.X);
  return {end.flow_ml_s, end.pressure_mmHg, m.circulation().state().y, nodes.gather(m.solver().X()), markers};
}

/// Largest difference over the largest value of b.
double relative(const std::vector<double>& a, const std::vector<double>& b)
{
  double difference = a.size() == b.size() ? 0 : 1e300, scale = 0;
  for (std::size_t n = 0; n < b.size(); ++n) {
    difference = max_or_nan(difference, std::abs(a[n] - b[n]));
    scale = max_or_nan(scale, std::abs(b[n]));
  }
  return difference / scale;
}

TEST(AorticRoot, FlowsPressuresNodesAndMarkersDoNotDependOnTheNumberOfRanks)
{
  const Outcome alone = run(MPI_COMM_SELF, 20), together = run(MPI_COMM_WORLD, 20);
  EXPECT_GT(std::abs(alone.flow[1]), 1.0);  // there is something to compare
  EXPECT_LT(relative(together.flow, alone.flow), 1e-10);
  EXPECT_LT(relative(together.pressure, alone.pressure), 1e-10);
  EXPECT_LT(relative(together.states, alone.states), 1e-10);
  EXPECT_LT(furthest_apart(together.X, alone.X), 1e-10);
  EXPECT_GT(alone.markers.size(), 100U);
  EXPECT_LT(furthest_apart(together.markers, alone.markers), 1e-10);
}

TEST(AorticRoot, RepeatedRunIsTheSameBitForBit)
{
  const Outcome a = run(MPI_COMM_WORLD, 10), b = run(MPI_COMM_WORLD, 10);
  EXPECT_EQ(a.flow, b.flow);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.states, b.states);
  EXPECT_EQ(furthest_apart(a.X, b.X), 0);
  EXPECT_EQ(furthest_apart(a.markers, b.markers), 0);
}

TEST(AorticRoot, MarkersChangeNothingButThemselves)
{
  const Outcome with = run(MPI_COMM_WORLD, 10);
  const Outcome without =
      run(MPI_COMM_WORLD, 10, {"markers.ventricle.start_s=1.0", "markers.aorta.start_s=1.0"});
  EXPECT_GT(with.markers.size(), 100U);
  EXPECT_TRUE(without.markers.empty());
  EXPECT_EQ(with.flow, without.flow);
  EXPECT_EQ(with.states, without.states);
  EXPECT_EQ(furthest_apart(with.X, without.X), 0);
}

}  // namespace
}  // namespace valsalva::coupling
