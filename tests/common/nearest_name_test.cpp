#include <gtest/gtest.h>

#include "common/nearest_name.hpp"

namespace valsalva::common {

TEST(NearestName, CountsInsertionsDeletionsReplacementsAndSwaps)
{
  EXPECT_EQ(typing_errors("abc", "abc"), 0u);
  EXPECT_EQ(typing_errors("abc", "abcd"), 1u);
  EXPECT_EQ(typing_errors("abc", "ac"), 1u);
  EXPECT_EQ(typing_errors("abc", "axc"), 1u);
  EXPECT_EQ(typing_errors("abc", "acb"), 1u);
  EXPECT_EQ(typing_errors("", "abc"), 3u);
  EXPECT_EQ(typing_errors("RP_mmhg", "Rp_mmHg"), 0u);
}

TEST(NearestName, IsEmptyIfNothingIsNear)
{
  EXPECT_EQ(nearest_name("tilte", {"title", "time"}), "title");
  EXPECT_EQ(nearest_name("quite_different", {"title", "time"}), "");
  EXPECT_EQ(nearest_name("ab", {"xy"}), "");
}

}  // namespace valsalva::common
