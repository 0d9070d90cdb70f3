#include "common/json.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace valsalva::common {

TEST(Json, NamesOfAllKindsComeBackAsTheyWere)
{
  const std::string odd = "quote \" backslash \\ new\nline tab\t \u00e9";
  EXPECT_EQ(Json::parse(json_text({{"case", odd}})).at("case"), odd);
}

TEST(Json, BytesThatAreNoUtf8AreReplaced)
{
  EXPECT_EQ(Json::parse(json_text({{"case", "a\xff"}})).at("case"), "a\xef\xbf\xbd");
}

TEST(Json, NumbersHaveNineDigitsAndInfinityIsNull)
{
  EXPECT_EQ(json_text({{"t_s", nine_digits(1.0 / 3.0)}}), "{\n  \"t_s\": 0.333333333\n}\n");
  EXPECT_EQ(json_text({{"sd", nine_digits(std::numeric_limits<double>::infinity())}}),
            "{\n  \"sd\": null\n}\n");
}

}  // namespace valsalva::common
