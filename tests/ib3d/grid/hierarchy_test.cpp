// The grid: boxes that cover the domain once, and spacings that are refused.
#include "ib3d/grid/hierarchy.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "common/error.hpp"
#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

TEST(Hierarchy, BoxesCoverTheDomainOnceAndAreMultiplesOfTheBlock)
{
  for (const int boxes : {1, 2, 3, 5, 8, 12}) {
    const Hierarchy grid(walled_box({2, 2, 6}), 2.0 / 16, MPI_COMM_SELF, boxes);
    const Level& level = grid.finest();
    EXPECT_EQ(level.patches.size(), static_cast<std::size_t>(boxes));
    EXPECT_EQ(level.cell_count(), level.box.volume());
    for (std::size_t a = 0; a < level.patches.size(); ++a) {
      for (int d = 0; d < 3; ++d) EXPECT_EQ(level.patches[a].box.size(d) % kCoarsestBlockingFactor, 0);
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_TRUE(intersect(level.patches[a].box, level.patches[b].box).empty());
    }
  }
}

TEST(Hierarchy, SpacingNamedInErrorDividesTheBox)
{
  const Domain box = walled_box({5, 5, 15});
  try {
    const Hierarchy grid(box, 0.11, MPI_COMM_SELF);
    FAIL() << "0.11 cm does not divide 5 cm";
  } catch (const CaseError& error) {
    const std::string said = error.what();
    const std::size_t at = said.find("Use ");
    ASSERT_NE(at, std::string::npos) << said;
    const double advised = std::strtod(said.c_str() + at + 4, nullptr);
    EXPECT_NO_THROW(Hierarchy(box, advised, MPI_COMM_SELF)) << advised;
  }
}

TEST(Hierarchy, SidesThatWouldNeedUnequalSpacingsAreRefused)
{
  EXPECT_THROW(Hierarchy(walled_box({5, 5.01, 15}), 5.0 / 48, MPI_COMM_SELF), CaseError);
  EXPECT_THROW(Hierarchy(walled_box({2, 2, 2}), 2.0 / 16, MPI_COMM_SELF, 100), CaseError);
}

TEST(Hierarchy, PeriodicSidesAreNoBoundary)
{
  Domain domain = walled_box({2, 2, 2});
  domain.sides[2] = domain.sides[3] = SideKind::periodic;
  const Hierarchy grid(domain, 2.0 / 16, MPI_COMM_SELF);
  const Level& level = grid.finest();
  for (const Side side : kSides)
    EXPECT_EQ(level.at_side(level.local_box(0), side), axis(side) != 1) << static_cast<int>(side);
}

}  // namespace
}  // namespace valsalva::ib3d
