// Which changes of a case a continued run accepts, and what it says about the others.
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "coupling/case_keys.hpp"
#include "coupling/run_checkpoints.hpp"

namespace valsalva::coupling {
namespace {

constexpr const char* kTube = R"(
[time]
end_s = 0.5
[[element]]
name = "source"
type = "pressure_source"
node = "lv"
pressure_mmHg = 1.0
[[element]]
name = "arteries"
type = "windkessel3"
node = "ao"
Rc_mmHg_s_ml = 0.05
Rp_mmHg_s_ml = 1.0
C_ml_mmHg = 0.2
initial_pressure_mmHg = 0.0
)";

CaseFile tube(const std::vector<std::string>& changes = {}, const std::string& more = "")
{
  return CaseFile::parse(kTube + more, "tube.toml", case_keys(), changes);
}

/// What check_same_run says about a case that was tube() with `then` and now has `now`.
std::string refusal(const CaseFile& now, const CaseFile& then = tube())
{
  try {
    check_same_run(now, then, "c.h5");
    return "";
  } catch (const CaseError& error) {
    return error.what();
  }
}

TEST(RestartRules, OutputCheckpointsTitleAndEndMayChange)
{
  const std::vector<std::string> beat{"time.period_s=0.5"};
  EXPECT_EQ(refusal(tube()), "");
  EXPECT_EQ(refusal(tube({"title=longer", "time.end_s=1.0", "time.period_s=0.5", "output.fields_every_s=0.1",
                          "checkpoint.keep=9"}),
                    tube(beat)),
            "");
}

TEST(RestartRules, EveryKeyThatChangesTheSolutionIsNamed)
{
  const std::string said = refusal(tube(
      {"grid.finest_cm=0.2", "element.arteries.C_ml_mmHg=0.3", "time.cfl=0.2", "output.probes_z_cm=[1.0]"}));
  for (const char* key : {"grid.finest_cm: is 0.2 now, was 0.104167", "element.arteries.C_ml_mmHg",
                          "time.cfl", "output.probes_z_cm", "c.h5"})
    EXPECT_NE(said.find(key), std::string::npos) << said;
  EXPECT_EQ(said.find("time.end_s"), std::string::npos) << said;
}

TEST(RestartRules, AddedAndRemovedElementsAreNamed)
{
  const CaseFile more = tube({},
                             "[[element]]\nname = \"veins\"\ntype = \"pressure_source\"\nnode = \"v\"\n"
                             "pressure_mmHg = 5.0\n");
  EXPECT_NE(refusal(more).find("element.veins: is new"), std::string::npos) << refusal(more);
  EXPECT_NE(refusal(tube(), more).find("element.veins: is missing now"), std::string::npos);
}

TEST(RestartRules, ARegionRefinedByHandMustStay)
{
  const auto refined = [](const std::string& level) {
    return tube({"grid.levels=3"},
                "[[refine]]\nname = \"jet\"\nlo_cm = [1, 1, 1]\nhi_cm = [2, 2, 2]\nlevel = " + level + "\n");
  };
  EXPECT_EQ(refusal(refined("1"), refined("1")), "");
  EXPECT_NE(refusal(refined("2"), refined("1")).find("refine.jet.level: is 2 now, was 1"), std::string::npos)
      << refusal(refined("2"), refined("1"));
}

TEST(RestartRules, ALongerRunMustKeepTheLengthOfItsBeat)
{
  // Without time.period_s the whole run is one beat, so a later end alone would change the sources.
  const std::string said = refusal(tube({"time.end_s=1.0"}));
  EXPECT_NE(said.find("set time.period_s = 0.5"), std::string::npos) << said;
  EXPECT_EQ(refusal(tube({"time.end_s=1.0", "time.period_s=0.5"})), "");
}

}  // namespace
}  // namespace valsalva::coupling
