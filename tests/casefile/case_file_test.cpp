#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "casefile/small_keys.hpp"

namespace valsalva::casefile {

namespace {

const std::string kArteries =
    "[[element]]\nname = 'arteries'\ntype = 'windkessel3'\nnode = 'ao'\nRp_mmHg_s_ml = 0.79\n";

/// A folder with case files that goes away with the test.
class CaseFolder : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_ / "sub"); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text)
  {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  CaseFile read(const std::string& path) { return CaseFile::read(path, small_keys()); }
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("valsalva_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

}  // namespace

TEST(CaseValues, GivenValuesWinOverDefaults)
{
  const CaseFile file =
      parse_small("title = 'A'\n[time]\nend_s = 2\nmax_steps = 7\n[grid]\nsides = 'open'\n");
  EXPECT_EQ(file.section("").text("title"), "A");
  EXPECT_DOUBLE_EQ(file.section("time").real("end_s"), 2.0);
  EXPECT_EQ(file.section("time").integer("max_steps"), 7);
  EXPECT_EQ(file.section("grid").text("sides"), "open");
  EXPECT_DOUBLE_EQ(file.section("time").real("cfl"), 0.4);
  EXPECT_TRUE(file.section("time").flag("pictures"));
  EXPECT_EQ(file.section("grid").reals("size_cm"), (std::vector<double>{5, 5, 15}));
  EXPECT_TRUE(file.section("time").is_given("max_steps"));
  EXPECT_FALSE(file.section("time").is_given("cfl"));
}

TEST(CaseValues, OneNumberStandsForAListOfOne)
{
  const CaseFile file = parse_small("[time]\nend_s = 1\n[grid]\nprobes_cm = 3\n");
  EXPECT_EQ(file.section("grid").reals("probes_cm"), std::vector<double>{3.0});
}

TEST(CaseValues, EntriesKeepTheirOrderAndTheKeysOfTheirType)
{
  const CaseFile file = parse_small("[time]\nend_s = 1\n" + kArteries +
                                    "[[element]]\nname = 'a'\ntype = 'source'\npressure_mmHg = [1, 2]\n");
  ASSERT_EQ(file.tables("element").size(), 2u);
  EXPECT_EQ(file.tables("element")[0].text("name"), "arteries");
  EXPECT_DOUBLE_EQ(file.tables("element")[0].real("pressure_mmHg"), 0.0);
  EXPECT_EQ(file.tables("element")[1].reals("pressure_mmHg"), (std::vector<double>{1, 2}));
  EXPECT_FALSE(file.tables("element")[1].has("delay_s"));
  EXPECT_EQ(file.entry("element", "a"), &file.tables("element")[1]);
  EXPECT_EQ(file.entry("element", "b"), nullptr);
}

TEST(CaseValues, AskingForAKeyByTheWrongKindIsAMistakeOfTheProgram)
{
  const CaseFile file = parse_small("[time]\nend_s = 1\n");
  EXPECT_THROW(file.section("time").text("end_s"), std::logic_error);
  EXPECT_THROW(file.section("time").real("end"), std::logic_error);
  EXPECT_THROW(file.section("space"), std::logic_error);
}

TEST(CaseOverrides, WinOverTheFileAndReachEntriesByName)
{
  const CaseFile file =
      parse_small("[time]\nend_s = 1\n" + kArteries,
                  {"time.end_s=0.25", "grid.sides=open", "title=two words",
                   "element.arteries.Rp_mmHg_s_ml=0.9", "grid.size_cm=[1, 2, 3]", "time.pictures=false"});
  EXPECT_DOUBLE_EQ(file.section("time").real("end_s"), 0.25);
  EXPECT_EQ(file.section("grid").text("sides"), "open");
  EXPECT_EQ(file.section("").text("title"), "two words");
  EXPECT_DOUBLE_EQ(file.entry("element", "arteries")->real("Rp_mmHg_s_ml"), 0.9);
  EXPECT_EQ(file.section("grid").reals("size_cm"), (std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(file.section("time").flag("pictures"));
}

TEST(CaseOverrides, AreCheckedLikeTheFile)
{
  const std::string toml = "[time]\nend_s = 1\n" + kArteries;
  EXPECT_EQ(refusal(toml, {"grid.finnest_cm=0.1"}),
            "--set: grid.finnest_cm: unknown key; did you mean 'finest_cm'?");
  EXPECT_EQ(
      refusal(toml, {"element.arterie.Rp_mmHg_s_ml=1"}),
      "--set: element.arterie.Rp_mmHg_s_ml: no [[element]] is named 'arterie'; did you mean 'arteries'?");
  EXPECT_NE(refusal(toml, {"grid.finest_cm"}).find("allowed is key=value"), std::string::npos);
}

TEST_F(CaseFolder, ExtendingFileWinsAndEntriesMergeByName)
{
  write("base.toml", "title = 'base'\n[time]\nend_s = 1\ncfl = 0.1\n" + kArteries);
  const CaseFile file =
      read(write("sub/case.toml",
                 "extends = '../base.toml'\n[time]\ncfl = 0.2\n[[element]]\nname = 'arteries'\n"
                 "pressure_mmHg = 80\n[[element]]\nname = 'b'\ntype = 'source'\npressure_mmHg = 1\n"));
  EXPECT_EQ(file.section("").text("title"), "base");
  EXPECT_DOUBLE_EQ(file.section("time").real("end_s"), 1.0);
  EXPECT_DOUBLE_EQ(file.section("time").real("cfl"), 0.2);
  ASSERT_EQ(file.tables("element").size(), 2u);
  EXPECT_DOUBLE_EQ(file.tables("element")[0].real("pressure_mmHg"), 80.0);
  EXPECT_DOUBLE_EQ(file.tables("element")[0].real("Rp_mmHg_s_ml"), 0.79);
}

TEST_F(CaseFolder, EntryOfAnotherTypeReplacesTheOneOfTheBase)
{
  write("base.toml", "[time]\nend_s = 1\n" + kArteries);
  const CaseFile file = read(write("case.toml",
                                   "extends = 'base.toml'\n[[element]]\nname = 'arteries'\ntype = 'source'\n"
                                   "pressure_mmHg = 80\n"));
  ASSERT_EQ(file.tables("element").size(), 1u);
  EXPECT_EQ(file.tables("element")[0].text("type"), "source");
}

TEST_F(CaseFolder, ProblemInTheBaseIsToldWithTheBaseAsItsFile)
{
  const std::string base = write("base.toml", "[time]\nend_s = 1\ncfll = 0.1\n");
  try {
    read(write("case.toml", "extends = 'base.toml'\n"));
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.problems().front().file, base);
    EXPECT_EQ(error.problems().front().line, 3);
  }
}

TEST_F(CaseFolder, FilesThatExtendEachOtherAreRefused)
{
  write("a.toml", "extends = 'b.toml'\n");
  EXPECT_THROW(read(write("b.toml", "extends = 'a.toml'\n")), CaseError);
  EXPECT_THROW(read(write("c.toml", "extends = 'missing.toml'\n")), CaseError);
}

TEST(ResolvedCase, ReadsBackToTheSameCase)
{
  const CaseFile file = parse_small(
      "title = 'say \"h\\i\"'\n[time]\nend_s = 0.1234567890123\n[grid]\nprobes_cm = [1e-7, 3]\n" + kArteries);
  const std::string resolved = file.resolved_toml();
  const CaseFile again = CaseFile::parse(resolved, "small.toml", small_keys());
  EXPECT_EQ(again.resolved_toml(), resolved);
  EXPECT_EQ(again.section("").text("title"), "say \"h\\i\"");
  EXPECT_EQ(again.section("time").real("end_s"), 0.1234567890123);
  EXPECT_EQ(again.section("grid").reals("probes_cm"), (std::vector<double>{1e-7, 3}));
  for (const Key& key : again.section("grid").keys()) EXPECT_TRUE(again.section("grid").is_given(key.name));
}

TEST(KeyTemplate, BecomesACaseOnceItsRequiredKeysAreFilledIn)
{
  std::string filled = template_toml(small_keys());
  const std::size_t required = filled.find("# end_s = ");
  ASSERT_NE(required, std::string::npos);
  filled.replace(required, 10, "end_s = 1");
  const CaseFile file = parse_small(filled);
  EXPECT_DOUBLE_EQ(file.section("time").real("end_s"), 1.0);
  EXPECT_NE(filled.find("# Rp_mmHg_s_ml = 0.79"), std::string::npos);
}

TEST(KeyReference, NamesEveryKeyWithItsUnit)
{
  const std::string page = keys_markdown(small_keys());
  EXPECT_NE(page.find("| `Rp_mmHg_s_ml` | mmHg s/ml | a number above 0 mmHg s/ml | required, e.g. `0.79` |"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("| `delay_s` | s | a number in s | absent |"), std::string::npos);
}

}  // namespace valsalva::casefile
