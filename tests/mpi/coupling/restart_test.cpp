// A run that is cut in two by a checkpoint: the same bit for bit on the same ranks, to rounding times the
// sharpness of the pressure solve on another number of ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "furthest_apart.hpp"
#include "ib3d/output/mpi_session.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace valsalva::coupling {

using namespace setup;
namespace {

/// The coarse aortic root with the ventricle's pressure rising at once, so that the valve moves, and arteries that
/// answer to the flow from the start.
struct Root {
  Root(MPI_Comm comm_, const std::vector<std::string>& more = {})
      : comm(comm_), model(make_case(more), Communicator(comm), timers)
  {
  }
  static Case make_case(const std::vector<std::string>& more)
  {
    const auto file = std::filesystem::path(VALSALVA_SOURCE_DIR) / "cases/aortic_root/case.toml";
    std::vector<std::string> keys{"grid.finest_cm=0.2083333333",
                                  "pressure.divergence_tolerance_1_s=1e-9",
                                  "element.ventricle.time_s=[0.0, 0.002, 0.15]",
                                  "element.ventricle.pressure_mmHg=[0.0, 20.0, 120.0]",
                                  "element.arteries.pressurise_s=0.0",
                                  "markers.aorta.every_s=0.002",
                                  "element.arteries.initial_pressure_mmHg=0.0"};
    keys.insert(keys.end(), more.begin(), more.end());
    return read_case(file.string(), keys);
  }
  void run(int steps)
  {
    for (int n = 0; n < steps; ++n) dt.push_back(model.model().advance(model.model().next_step(1.0)).dt_s);
  }
  void save(const std::string& path)
  {
    Checkpoint c = Checkpoint::create(path, comm);
    model.model().save_or_restore(c);
    c.close();
  }
  void restore(const std::string& path)
  {
    Checkpoint c = Checkpoint::open(path, comm);
    model.model().save_or_restore(c);
  }
  const InterfaceState& interface() { return model.model().interface(); }
  std::vector<ib3d::Marker> markers() { return model.solver().markers().gather(comm); }
  std::vector<Vec3> X() { return model.solver().nodes().gather(model.solver().X()); }

  MPI_Comm comm;
  Timers timers;
  CaseModel model;
  std::vector<double> dt;
};

std::vector<std::vector<double>> local_fields(Root& root)
{
  const ib3d::NavierStokes& fluid = root.model.solver().fluid();
  std::vector<std::vector<double>> all;
  for (std::size_t l = 0; l < fluid.u().size(); ++l)
    for (int p = 0; p < fluid.p()[l].patch_count(); ++p) {
      all.push_back(fluid.p()[l][p].data());
      for (int d = 0; d < 3; ++d) all.push_back(fluid.u()[l](p, d).data());
    }
  return all;
}

/// The same markers in positions that differ by at most `tolerance`, cm.
void expect_same_markers(Root& a, Root& b, double tolerance)
{
  const std::vector<ib3d::Marker> of_a = a.markers(), of_b = b.markers();
  ASSERT_EQ(of_a.size(), of_b.size());
  ASSERT_GT(of_a.size(), 100U);
  for (std::size_t n = 0; n < of_a.size(); ++n) {
    ASSERT_LE(norm(of_a[n].X - of_b[n].X), tolerance);
    ASSERT_EQ(of_a[n].id, of_b[n].id);
    ASSERT_EQ(of_a[n].group, of_b[n].group);
    ASSERT_EQ(of_a[n].seeded_s, of_b[n].seeded_s);
  }
}

void expect_equal_to_rounding(Root& a, Root& b)
{
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_NEAR(a.interface().flow_ml_s[m], b.interface().flow_ml_s[m],
                1e-10 * std::abs(b.interface().flow_ml_s[1]));
    EXPECT_NEAR(a.interface().pressure_mmHg[m], b.interface().pressure_mmHg[m], 1e-10 * 100);
  }
  EXPECT_LT(furthest_apart(a.X(), b.X()), 1e-10);
  expect_same_markers(a, b, 1e-10);
}

TEST(Restart, ContinuesBitForBitOnTheSameRanks)
{
  const std::string path = ib3d::shared_file("same_ranks.h5");
  Root whole(MPI_COMM_WORLD), first(MPI_COMM_WORLD), second(MPI_COMM_WORLD);
  whole.run(80);  // long enough for several estimates of the elastic bound
  first.run(40);
  first.save(path);
  second.run(3);  // what is restored must not depend on what was there
  second.restore(path);
  EXPECT_EQ(second.model.model().t(), first.model.model().t());
  second.dt.clear();
  second.run(40);

  EXPECT_EQ(second.model.model().step(), 80);
  EXPECT_EQ(second.dt, std::vector<double>(whole.dt.begin() + 40, whole.dt.end()));
  EXPECT_EQ(second.interface().t_s, whole.interface().t_s);
  EXPECT_EQ(second.interface().flow_ml_s, whole.interface().flow_ml_s);
  EXPECT_EQ(second.interface().pressure_mmHg, whole.interface().pressure_mmHg);
  EXPECT_EQ(second.model.circulation().state(), whole.model.circulation().state());
  expect_same_markers(second, whole, 0);
  EXPECT_EQ(second.model.circulation().evaluations(), whole.model.circulation().evaluations());
  EXPECT_TRUE(second.X() == whole.X());
  EXPECT_TRUE(local_fields(second) == local_fields(whole));
}

TEST(Restart, ContinuesBitForBitWithTheMidpointSchemeAndFixedSteps)
{
  const std::vector<std::string> keys{"structure.scheme=midpoint", "time.dt_fixed_s=1e-4"};
  const std::string path = ib3d::shared_file("midpoint.h5");
  Root whole(MPI_COMM_WORLD, keys), second(MPI_COMM_WORLD, keys);
  whole.run(10);
  whole.save(path);
  whole.run(10);
  second.restore(path);
  second.run(10);
  EXPECT_EQ(second.interface().flow_ml_s, whole.interface().flow_ml_s);
  EXPECT_EQ(second.model.circulation().evaluations(), whole.model.circulation().evaluations());
  EXPECT_TRUE(second.X() == whole.X());
  EXPECT_TRUE(local_fields(second) == local_fields(whole));
}

TEST(Restart, ContinuesOnAnotherNumberOfRanksToRounding)
{
  const std::vector<std::string> keys{"time.dt_fixed_s=1e-4"};
  const std::string together_path = ib3d::shared_file("together.h5");
  const auto alone_path = [](int rank) { return ib3d::shared_file("alone_" + std::to_string(rank) + ".h5"); };
  Root together(MPI_COMM_WORLD, keys), alone(MPI_COMM_SELF, keys);
  together.run(10);
  together.save(together_path);
  alone.run(10);
  alone.save(alone_path(ib3d::mpi_rank()));
  MPI_Barrier(MPI_COMM_WORLD);

  Root from_together(MPI_COMM_SELF, keys), from_alone(MPI_COMM_WORLD, keys);
  from_together.restore(together_path);
  from_alone.restore(alone_path(0));
  alone.run(10);
  from_together.run(10);
  from_alone.run(10);
  EXPECT_GT(std::abs(alone.interface().flow_ml_s[1]), 1.0);  // there is something to compare
  expect_equal_to_rounding(from_together, alone);
  expect_equal_to_rounding(from_alone, alone);
}

}  // namespace
}  // namespace valsalva::coupling
