// From the text of a case to a running model.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/case_keys.hpp"
#include "coupling/model_from_case.hpp"

namespace valsalva::coupling {
namespace {

CaseFile small_case(const std::vector<std::string>& overrides = {})
{
  return CaseFile::parse(R"(
[time]
end_s = 0.01
dt_fixed_s = 1e-3
[domain]
size_cm = [2.0, 2.0, 4.0]
[grid]
finest_cm = 0.125
[pressure]
divergence_tolerance_1_s = 1e-7
[[opening]]
name = "inlet"
side = "z_lo"
center_cm = [1.0, 1.0]
radius_cm = 0.6
port = "lv"
[[opening]]
name = "outlet"
side = "z_hi"
center_cm = [1.0, 0.9]
radius_cm = 0.7
port = "ao"
[[element]]
name = "ventricle"
type = "pressure_source"
node = "lv"
pressure_mmHg = 10.0
[[element]]
name = "arteries"
type = "windkessel3"
node = "ao"
Rc_mmHg_s_ml = 0.033
Rp_mmHg_s_ml = 0.79
C_ml_mmHg = 1.75
initial_pressure_mmHg = 5.0
)",
                         "small.toml", case_keys(), overrides);
}

TEST(CaseModel, FlowInIsFlowOutBetweenWalls)
{
  Timers timers;
  CaseModel model(small_case(), MPI_COMM_SELF, timers);
  const double volume = 2 * 2 * 4;
  for (int n = 0; n < 3; ++n) {
    const StepReport step = model.model().advance(model.model().next_step(0.01));
    const std::vector<double>& Q = model.model().interface().flow_ml_s;
    EXPECT_LT(step.divergence_rms, 1e-7);
    EXPECT_GT(Q[1], 0.5 * (n + 1));
    EXPECT_LT(std::abs(Q[0] + Q[1]), 1e-7 * volume);  // Cauchy-Schwarz
  }
  EXPECT_EQ(model.model().step(), 3);
}

TEST(CaseModel, FlowOfTheInterfaceIsTheFlowOfTheVelocity)
{
  Timers timers;
  CaseModel model(small_case(), MPI_COMM_SELF, timers);
  for (int n = 0; n < 3; ++n) model.model().advance(model.model().next_step(0.01));
  const ib3d::NavierStokes& fluid = model.root().fluid();
  const std::vector<double> Q = ib3d::OpeningFaces(fluid.grid(), fluid.openings()).flow(fluid.u());
  for (std::size_t m = 0; m < 2; ++m) EXPECT_NEAR(Q[m] / model.model().interface().flow_ml_s[m], 1.0, 1e-7);
}

TEST(CaseModel, OpenSidesLetFluidOutBetweenTheOpenings)
{
  Timers timers;
  CaseModel model(small_case({"domain.sides=open"}), MPI_COMM_SELF, timers);
  for (int n = 0; n < 3; ++n) model.model().advance(model.model().next_step(0.01));
  const std::vector<double>& Q = model.model().interface().flow_ml_s;
  EXPECT_LT(Q[0], 0);
  EXPECT_LT(Q[1], 0);  // both ends are above the pressure outside, 0
}

TEST(CaseModel, OpeningsThatOverlapOrLeaveTheBoxAreRefused)
{
  const CaseFile out_of_box = small_case({"opening.inlet.radius_cm=1.1"});
  EXPECT_THROW(openings_from_case(out_of_box, domain_from_case(out_of_box)), CaseError);
  const CaseFile overlapping = small_case({"opening.outlet.side=z_lo"});
  EXPECT_THROW(openings_from_case(overlapping, domain_from_case(overlapping)), CaseError);
}

}  // namespace
}  // namespace valsalva::coupling
