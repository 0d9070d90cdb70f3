#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "common/comm.hpp"
#include "common/end_together.hpp"
#include "common/error.hpp"

namespace valsalva::common {

TEST(Ranks, SumRunsInRankOrderAndIsTheSameEverywhere)
{
  const Communicator comm(MPI_COMM_WORLD);
  double in_order = 0.0;
  for (int r = 0; r < comm.size(); ++r) in_order += 1.0 / (3.0 + r);
  const double sum = comm.sum(1.0 / (3.0 + comm.rank()));
  EXPECT_EQ(sum, in_order);
  EXPECT_EQ(comm.min(sum), comm.max(sum));
}

TEST(Ranks, LargestSmallestAndAnyAreOverAllRanks)
{
  const Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(comm.max(comm.rank()), comm.size() - 1.0);
  EXPECT_EQ(comm.min(-comm.rank()), 1.0 - comm.size());
  EXPECT_TRUE(comm.any(comm.rank() == comm.size() - 1));
  EXPECT_FALSE(comm.any(false));
  EXPECT_EQ(comm.from_rank_0(7.0 + comm.rank()), 7.0);
}

TEST(Ranks, ANanOfOneRankIsTheLargestAndTheSmallest)
{
  const Communicator comm(MPI_COMM_WORLD);
  for (int r = 0; r < comm.size(); ++r) {
    const double x = comm.rank() == r ? std::numeric_limits<double>::quiet_NaN() : 1.0;
    EXPECT_TRUE(std::isnan(comm.max(x)));
    EXPECT_TRUE(std::isnan(comm.min(x)));
  }
}

TEST(Ranks, ErrorFoundByAllEndsAllWithTheSameCode)
{
  const Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(end_together(comm, []() -> int { throw CaseError("time.end_s", "printed once"); }), 2);
}

TEST(Ranks, ErrorOfOneRankAtTheEndIsTheCodeOfAll)
{
  const Communicator comm(MPI_COMM_WORLD);
  const auto last_rank_fails = [&] {
    if (comm.rank() == comm.size() - 1) throw IoError("printed once, by the last rank");
    return 0;
  };
  EXPECT_EQ(end_together(comm, last_rank_fails), 4);
}

TEST(OnRankZero, AFailureOfRankZeroIsAFailureOfAllRanks)
{
  const Communicator comm(MPI_COMM_WORLD);
  int runs = 0;
  on_rank_0(comm, [&] { ++runs; });
  EXPECT_EQ(comm.sum(runs), 1);
  EXPECT_THROW(on_rank_0(comm, [] { throw IoError("the disk is full"); }), IoError);
  EXPECT_THROW(on_rank_0(comm, [] { throw SolverError("no convergence"); }), SolverError);
  EXPECT_THROW(on_rank_0(comm, [] { throw CaseError("time.end_s", "is negative"); }), CaseError);
  EXPECT_THROW(on_rank_0(comm, [] { throw std::logic_error("wrong"); }), std::exception);
}

TEST(OnRankZero, ItsNumbersAreThoseOfAllRanks)
{
  const Communicator comm(MPI_COMM_WORLD);
  std::vector<double> values{-1.0, 1.0 * comm.rank()};
  on_rank_0(
      comm,
      [&] {
        values = {1.0 / 3.0, 2.0};
      },
      values);
  EXPECT_EQ(values, (std::vector<double>{1.0 / 3.0, 2.0}));
  EXPECT_THROW(on_rank_0(
                   comm, [&] { std::filesystem::remove("/proc/self/status"); }, values),
               std::exception);
}

TEST(NoteFailure, RankZeroNotesWhatAllRanksFailWith)
{
  const Communicator comm(MPI_COMM_WORLD);
  int notes = 0;
  EXPECT_THROW(note_failure(
                   comm, [] { throw IoError("on all"); }, [&] { ++notes; }),
               IoError);
  EXPECT_EQ(notes, comm.is_rank_0() ? 1 : 0);
  note_failure(
      comm, [] {}, [&] { ++notes; });
  EXPECT_EQ(comm.sum(notes), 1);
}

}  // namespace valsalva::common
