// Values of a case that do not fit together are refused together, each by its key and place.
#include "setup/checks.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "complaint.hpp"
#include "setup/read_case.hpp"

namespace valsalva::setup {

namespace {

const std::string kRoot = std::string(VALSALVA_SOURCE_DIR) + "/cases/aortic_root/case.toml";

std::vector<std::string> refused_keys(const std::vector<std::string>& overrides)
{
  std::vector<std::string> keys;
  try {
    read_case(kRoot, overrides);
  } catch (const CaseError& error) {
    for (const CaseProblem& problem : error.problems()) keys.push_back(problem.key);
  }
  return keys;
}

using Keys = std::vector<std::string>;

TEST(Checks, ABundledCaseHasNoProblems)
{
  EXPECT_TRUE(problems_of(read_case(kRoot)).empty());
}

TEST(Checks, EveryImpossibleDimensionOfTheRootIsNamedAtOnce)
{
  EXPECT_EQ(refused_keys({"root.sinus_end_z_cm=4.0", "root.sinus_bulge_cm=1.2", "grid.finest_cm=0.3125"}),
            (Keys{"grid.finest_cm", "root.sinus_end_z_cm", "root.sinus_bulge_cm"}));
  EXPECT_EQ(refused_keys(
                {"root.commissure_height_cm=3.0", "root.sinus_end_z_cm=7.0", "root.ascending_radius_cm=2.4"}),
            (Keys{"root.commissure_height_cm", "root.ascending_radius_cm"}));
}

TEST(Checks, ARangeIsThatOfTheKeyTable)
{
  EXPECT_EQ(refused_keys({"leaflets.free_edge_ratio=1.31"}), Keys{"leaflets.free_edge_ratio"});
  EXPECT_EQ(refused_keys({"leaflets.radial_stiffness_dyn_cm=0.0"}), Keys{"leaflets.radial_stiffness_dyn_cm"});
  EXPECT_EQ(refused_keys({"leaflets.free_edge_ratio=1.29"}), Keys{});
}

TEST(Checks, WhatNeedsA3DRunIsRefusedWithoutOpenings)
{
  const std::string said = complaint(
      [] { parse_case("[time]\nend_s = 1.0\n[structure]\nkind = \"aortic_root\"\n", "closed_box.toml"); });
  EXPECT_NE(said.find("closed_box.toml:4:1: structure.kind: needs a 3D run"), std::string::npos) << said;
}

TEST(Checks, PfmgAndVorticityNeedTheRightNumberOfLevels)
{
  EXPECT_EQ(refused_keys({"pressure.solver=pfmg", "grid.levels=2"}), Keys{"pressure.solver"});
  EXPECT_EQ(refused_keys({"grid.vorticity_1_s=100"}), Keys{"grid.vorticity_1_s"});
}

TEST(Checks, BeatsThatAreComparedNeedAPeriod)
{
  EXPECT_EQ(refused_keys({"time.stop_when_periodic_within=0.01"}), Keys{"time.stop_when_periodic_within"});
  EXPECT_EQ(refused_keys({"time.start=periodic"}), Keys{"time.start"});
}

}  // namespace
}  // namespace valsalva::setup
