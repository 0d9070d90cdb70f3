#include <gtest/gtest.h>

#include "casefile/small_keys.hpp"

namespace valsalva::casefile {

const std::string kTime = "[time]\nend_s = 1.0\n";

TEST(CaseErrors, UnknownKeyIsToldWithItsPlaceAndTheNearestKnownKey)
{
  EXPECT_EQ(refusal(kTime + "[grid]\n  finnest_cm = 0.1\n"),
            "small.toml:4:3: grid.finnest_cm: unknown key; did you mean 'finest_cm'?");
}

TEST(CaseErrors, KeyLikeNoOtherIsAnsweredWithTheKeysOfItsSection)
{
  EXPECT_EQ(
      refusal(kTime + "[grid]\nzzzzzzzzzz = 1\n"),
      "small.toml:4:1: grid.zzzzzzzzzz: unknown key; [grid] knows finest_cm, size_cm, probes_cm, sides");
}

TEST(CaseErrors, KeyInTheWrongSectionIsSentToItsOwn)
{
  EXPECT_EQ(refusal(kTime + "[grid]\npictures = true\n"),
            "small.toml:4:1: grid.pictures: this key belongs in [time]");
}

TEST(CaseErrors, OtherUnitIsNamedTogetherWithTheRightOne)
{
  EXPECT_EQ(
      refusal(kTime + "[grid]\nfinest_mm = 1\n"),
      "small.toml:4:1: grid.finest_mm: the unit of this key is cm; convert the value and write 'finest_cm'");
  EXPECT_NE(refusal(kTime + "[[element]]\nname = 'a'\ntype = 'source'\npressure_kPa = 1.0\n")
                .find("'pressure_mmHg'"),
            std::string::npos);
}

TEST(CaseErrors, KeyWithoutItsUnitIsSentToTheFullName)
{
  EXPECT_NE(refusal(kTime + "[grid]\nfinest = 0.1\n").find("write 'finest_cm'"), std::string::npos);
}

TEST(CaseErrors, ValueOutOfRangeIsToldWithTheAllowedRangeAndUnit)
{
  EXPECT_EQ(refusal(kTime + "[grid]\nfinest_cm = 3.5\n"),
            "small.toml:4:1: grid.finest_cm: found 3.5, allowed is a number from 0.001 to 1 cm");
  EXPECT_EQ(refusal("[time]\nend_s = 0\n"),
            "small.toml:2:1: time.end_s: found 0.0, allowed is a number above 0 s");
  EXPECT_NE(refusal("[time]\nend_s = inf\n"), "");
  EXPECT_NE(refusal("[time]\nend_s = nan\n"), "");
}

TEST(CaseErrors, ValueOfTheWrongKindIsToldWithTheAllowedKind)
{
  EXPECT_EQ(refusal("[time]\nend_s = 'long'\n"),
            "small.toml:2:1: time.end_s: found \"long\", allowed is a number above 0 s");
  EXPECT_NE(refusal(kTime + "pictures = 1\n").find("true or false"), std::string::npos);
  EXPECT_NE(refusal(kTime + "max_steps = 1.5\n").find("a whole number from 1 to 1000"), std::string::npos);
  EXPECT_NE(refusal(kTime + "[grid]\nsize_cm = [1, 'a', 2]\n").find("not a number"), std::string::npos);
}

TEST(CaseErrors, ListOfTheWrongLengthIsRefused)
{
  EXPECT_NE(refusal(kTime + "[grid]\nsize_cm = [1, 2]\n").find("found 2 in the list, allowed is 3 numbers"),
            std::string::npos);
  EXPECT_NE(refusal(kTime + "[grid]\nsize_cm = [1, 2, -3]\n").find("found -3.0 in the list"),
            std::string::npos);
}

TEST(CaseErrors, UnknownChoiceIsAnsweredWithAllOfThem)
{
  EXPECT_EQ(
      refusal(kTime + "[grid]\nsides = 'walls'\n"),
      "small.toml:4:1: grid.sides: found \"walls\", allowed is wall, open or periodic; did you mean 'wall'?");
}

TEST(CaseErrors, MissingKeyIsToldWithItsMeaning)
{
  EXPECT_EQ(refusal("[time]\ncfl = 0.2\n"),
            "small.toml:1:1: time.end_s: missing: End of the run (a number above 0 s)");
  EXPECT_NE(refusal("").find("time.end_s: missing"), std::string::npos);
}

TEST(CaseErrors, KeyWithAWrongUnitIsNotAlsoCalledMissing)
{
  EXPECT_EQ(refusal("[time]\nend_ms = 800\n").find("missing"), std::string::npos);
}

TEST(CaseErrors, UnknownSectionsAndEntriesAreTold)
{
  EXPECT_EQ(refusal(kTime + "[girdle]\n[gird]\n"),
            "small.toml:3:1: girdle: unknown section; known are time, grid or element\n"
            "small.toml:4:1: gird: unknown section; did you mean 'grid'?");
  EXPECT_NE(refusal(kTime + "[element]\nname = 'a'\n").find("write [[element]]"), std::string::npos);
  EXPECT_NE(refusal(kTime + "[[grid]]\nfinest_cm = 0.1\n").find("write [grid]"), std::string::npos);
}

TEST(CaseErrors, EntriesNeedAKnownTypeAndAUniqueName)
{
  EXPECT_NE(refusal(kTime + "[[element]]\nname = 'a'\ntype = 'sorce'\n").find("did you mean 'source'?"),
            std::string::npos);
  EXPECT_NE(refusal(kTime + "[[element]]\nname = 'a'\n").find("element.a.type: missing"), std::string::npos);
  const std::string one = "[[element]]\nname = 'a'\ntype = 'source'\npressure_mmHg = 1\n";
  EXPECT_EQ(refusal(kTime + one), "");
  EXPECT_EQ(refusal(kTime + one + one),
            "small.toml:7:1: element.a: a second [[element]] of this name; the first is in line 3");
}

TEST(CaseErrors, AllProblemsOfAFileAreFoundAtOnceInTheOrderOfTheFile)
{
  const std::string all = refusal(
      "tilte = 'x'\n[time]\ncfl = 0.9\n[grid]\nfinest_mm = 1\n[[element]]\nname = 'a'\ntype = 'windkessel3'\n"
      "node = 'ao'\nRp_mmHg_s_ml = -1\n");
  EXPECT_EQ(
      all,
      "small.toml:1:1: tilte: unknown key; did you mean 'title'?\n"
      "small.toml:2:1: time.end_s: missing: End of the run (a number above 0 s)\n"
      "small.toml:3:1: time.cfl: found 0.9, allowed is a number from 0.05 to 0.5\n"
      "small.toml:5:1: grid.finest_mm: the unit of this key is cm; convert the value and write 'finest_cm'\n"
      "small.toml:10:1: element.a.Rp_mmHg_s_ml: found -1.0, allowed is a number above 0 mmHg s/ml");
}

TEST(CaseErrors, BrokenTomlIsToldWithItsPlace)
{
  const std::string text = refusal("[time]\nend_s = = 1\n");
  EXPECT_TRUE(text.starts_with("small.toml:2:9: this is not TOML")) << text;
}

TEST(CaseErrors, ProblemsFoundByPhysicsGetTheirPlace)
{
  const CaseFile file = parse_small(
      kTime + "[[element]]\nname = 'arteries'\ntype = 'windkessel3'\nnode = 'ao'\nRp_mmHg_s_ml = 1\n");
  const auto located = [&](const std::string& key) {
    return std::string(file.locate(CaseError(key, "bad.")).what());
  };
  EXPECT_EQ(located("time.end_s"), "small.toml:2:1: time.end_s: bad.");
  EXPECT_EQ(located("time.cfl"), "small.toml:1:1: time.cfl: bad.");
  EXPECT_EQ(located("element.arteries.Rp_mmHg_s_ml"), "small.toml:7:1: element.arteries.Rp_mmHg_s_ml: bad.");
  EXPECT_EQ(located("element \"arteries\": Rp_mmHg_s_ml"),
            "small.toml:7:1: element.arteries.Rp_mmHg_s_ml: bad.");
  EXPECT_EQ(located("element \"arteries\""), "small.toml:3:1: element.arteries: bad.");
  EXPECT_EQ(located("node \"ao\""), "small.toml:6:1: element.arteries.node = \"ao\": bad.");
  EXPECT_EQ(located("node \"lv\""), "small.toml: node \"lv\": bad.");
  EXPECT_EQ(located("grid.finest_cm"), "small.toml: grid.finest_cm: bad.");
}

TEST(CaseErrors, FileThatIsNotThereIsAnInputError)
{
  EXPECT_THROW(CaseFile::read("/no/such/case.toml", small_keys()), IoError);
  EXPECT_THROW(CaseFile::read("/tmp", small_keys()), IoError);
}

}  // namespace valsalva::casefile
