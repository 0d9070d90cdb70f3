// The valve on a coarse grid: order in time of both structure schemes, and the same valve read from fibre files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "ib3d/structure/fibres/fibre_files.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace valsalva::setup {

using namespace coupling;
namespace {

/// The root while its outlet is being pressurised, to `end_s` in steps of dt.
std::vector<Vec3> positions(double end_s, double dt, std::vector<std::string> overrides)
{
  const auto root = std::filesystem::path(VALSALVA_SOURCE_DIR) / "cases/aortic_root/case.toml";
  overrides.insert(overrides.end(), {"grid.finest_cm=0.2083333333", "pressure.divergence_tolerance_1_s=1e-8",
                                     "time.dt_fixed_s=" + std::to_string(dt)});
  const Case c = read_case(root.string(), overrides);
  Timers timers;
  CaseModel m(c, Communicator(MPI_COMM_WORLD), timers);
  while (m.model().t() < end_s - 1e-9) m.model().advance(m.model().next_step(end_s));
  return m.solver().nodes().gather(m.solver().X());
}

double rms_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += dot(a[n] - b[n], a[n] - b[n]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Order from three step sizes (Richardson): log2 |X(dt) - X(dt/2)| / |X(dt/2) - X(dt/4)|.
double observed_order(const std::string& scheme)
{
  const double end_s = 1.6e-3;
  const std::vector<std::string> key{"structure.scheme=\"" + scheme + "\""};
  const auto coarse = positions(end_s, 8e-5, key), middle = positions(end_s, 4e-5, key),
             fine = positions(end_s, 2e-5, key);
  return std::log2(rms_difference(coarse, middle) / rms_difference(middle, fine));
}

TEST(StructureScheme, MidpointIsSecondOrderInTime)
{
  EXPECT_GT(observed_order("midpoint"), 1.7);
}

TEST(StructureScheme, LeapfrogIsAtLeastFirstOrderInTime)
{
  EXPECT_GT(observed_order("leapfrog"), 0.9);
}

TEST(FibreFiles, ValveReadFromFilesMovesLikeTheOneBuiltInMemory)
{
  const auto folder = std::filesystem::temp_directory_path() / "valsalva_valve_files";
  std::filesystem::create_directories(folder);
  const std::string prefix = (folder / "valve").string();
  ib3d::write_fibre_files(ib3d::build_aortic_root({}, {}, {}, 5.0 / 24), prefix);
  const auto built = positions(5e-4, 1e-4, {});
  const auto read =
      positions(5e-4, 1e-4, {"structure.kind=\"files\"", "structure.files_prefix=\"" + prefix + "\""});
  ASSERT_EQ(built.size(), read.size());
  EXPECT_GT(rms_difference(built, ib3d::build_aortic_root({}, {}, {}, 5.0 / 24).X), 1e-6);
  EXPECT_LT(rms_difference(built, read), 1e-9);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace valsalva::setup
