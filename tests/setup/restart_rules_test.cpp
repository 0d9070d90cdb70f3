// Which changes of a case a continued run accepts, and what it says about the others.
#include <gtest/gtest.h>

#include "complaint.hpp"
#include "coupling/small_cases.hpp"
#include "setup/same_run.hpp"

namespace valsalva::setup {

using namespace coupling;
namespace {

/// A case that leaves the length of a beat to the end of the run.
Case one_beat(Changes changes = {}, const std::string& more = "")
{
  changes.insert(changes.begin(), {"time.end_s=0.5", "time.period_s=0"});
  return circulation_case(changes, more);
}

/// What check_same_run says about a case that was one_beat() with `then` and now has `now`.
std::string refusal(const Case& now, const Case& then = one_beat())
{
  return complaint([&] { check_same_run(now, then.source.resolved_toml(), "c.h5"); });
}

TEST(RestartRules, OutputCheckpointsTitleAndEndMayChange)
{
  const Changes beat{"time.period_s=0.5"};
  EXPECT_EQ(refusal(one_beat()), "");
  EXPECT_EQ(refusal(one_beat({"title=longer", "time.end_s=1.0", "time.period_s=0.5",
                              "output.fields_every_s=0.1", "checkpoint.keep=9"}),
                    one_beat(beat)),
            "");
}

TEST(RestartRules, EveryKeyThatChangesTheSolutionIsNamed)
{
  const std::string said = refusal(one_beat(
      {"grid.finest_cm=0.2", "element.arteries.C_ml_mmHg=0.3", "time.cfl=0.2", "output.probes_z_cm=[1.0]"}));
  for (const char* key : {"grid.finest_cm: is 0.2 now, was 0.104167", "element.arteries.C_ml_mmHg",
                          "time.cfl", "output.probes_z_cm", "c.h5"})
    EXPECT_NE(said.find(key), std::string::npos) << said;
  EXPECT_EQ(said.find("time.end_s"), std::string::npos) << said;
}

TEST(RestartRules, AddedAndRemovedElementsAreNamed)
{
  const Case more = one_beat({},
                             "[[element]]\nname = \"veins\"\ntype = \"pressure_source\"\nnode = \"v\"\n"
                             "pressure_mmHg = 5.0\n");
  EXPECT_NE(refusal(more).find("element.veins: is new"), std::string::npos) << refusal(more);
  EXPECT_NE(refusal(one_beat(), more).find("element.veins: is missing now"), std::string::npos);
}

TEST(RestartRules, ARegionRefinedByHandMustStay)
{
  const auto refined = [](const std::string& level) {
    return tube_case(
        {"grid.levels=3"},
        "[[refine]]\nname = \"jet\"\nlo_cm = [1, 1, 1]\nhi_cm = [2, 2, 2]\nlevel = " + level + "\n");
  };
  EXPECT_EQ(refusal(refined("1"), refined("1")), "");
  EXPECT_NE(refusal(refined("2"), refined("1")).find("refine.jet.level: is 2 now, was 1"), std::string::npos)
      << refusal(refined("2"), refined("1"));
}

TEST(RestartRules, ALongerRunMustKeepTheLengthOfItsBeat)
{
  // Without time.period_s the whole run is one beat, so a later end alone would change the sources.
  const std::string said = refusal(one_beat({"time.end_s=1.0"}));
  EXPECT_NE(said.find("set time.period_s = 0.5"), std::string::npos) << said;
  EXPECT_EQ(refusal(one_beat({"time.end_s=1.0", "time.period_s=0.5"})), "");
}

}  // namespace
}  // namespace valsalva::setup
