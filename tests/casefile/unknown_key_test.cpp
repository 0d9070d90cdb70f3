#include "casefile/unknown_key.hpp"

#include <gtest/gtest.h>

namespace valsalva::casefile {

TEST(UnitSuffix, IsTheUnitAsKeysEndWithIt)
{
  EXPECT_EQ(unit_suffix("mmHg s^2/ml"), "mmHg_s2_ml");
  EXPECT_EQ(unit_suffix("g/(cm s)"), "g_cm_s");
  EXPECT_EQ(unit_suffix("1/s"), "1_s");
}

TEST(UnitSuffix, OnlyUnitsMakeAnotherUnitOfTheSameKey)
{
  const std::vector<Key> keys = {real("end_s", "s", ""), real("R_mmHg_s_ml", "mmHg s/ml", "")};
  EXPECT_EQ(key_with_other_unit("end_ms", keys), &keys[0]);
  EXPECT_EQ(key_with_other_unit("end", keys), &keys[0]);
  EXPECT_EQ(key_with_other_unit("R_dyn_s_cm5", keys), &keys[1]);
  EXPECT_EQ(key_with_other_unit("end_of_run", keys), nullptr);
  EXPECT_EQ(key_with_other_unit("ending_s", keys), nullptr);
}

}  // namespace valsalva::casefile
