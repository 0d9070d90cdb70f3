#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "common/comm.hpp"
#include "common/end_together.hpp"
#include "common/error.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/progress.hpp"
#include "common/stop_signal.hpp"
#include "common/timers.hpp"

namespace valsalva::common {

TEST(Progress, TimeLeftIsElapsedTimesWhatIsLeftOverWhatIsDone)
{
  EXPECT_EQ(eta_text(0.25, 30.0), "1 min 30 s");
  EXPECT_EQ(eta_text(0.5, 42.0), "42 s");
  EXPECT_EQ(eta_text(0.1, 3600.0), "9 h 0 min");
  EXPECT_EQ(eta_text(1.0, 3600.0), "0 s");
  EXPECT_EQ(eta_text(0.0, 10.0), "?");
}

TEST(Progress, DurationsCarryIntoTheNextUnit)
{
  EXPECT_EQ(duration_text(59.6), "1 min 0 s");
  EXPECT_EQ(duration_text(190.0), "3 min 10 s");
  EXPECT_EQ(duration_text(90061.0), "1 d 1 h");
  EXPECT_EQ(duration_text(-1.0), "?");
}

TEST(Progress, BarIsFilledInProportion)
{
  EXPECT_EQ(progress_bar(0.5, 8), "[####----]");
  EXPECT_EQ(progress_bar(0.0, 4), "[----]");
  EXPECT_EQ(progress_bar(7.0, 4), "[####]");
}

TEST(PhaseTimers, OuterPhaseHoldsTheTimeOfTheInnerOne)
{
  Timers timers;
  for (int i = 0; i < 3; ++i) {
    const auto outer = timers.time("outer");
    const auto inner = timers.time("inner");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_GE(timers.seconds("inner"), 0.006);
  EXPECT_GE(timers.seconds("outer"), timers.seconds("inner"));
  EXPECT_GE(timers.wall(), timers.seconds("outer"));
  EXPECT_EQ(timers.phases()[0].calls, 3);
  EXPECT_EQ(timers.seconds("never"), 0.0);
  EXPECT_NE(timers.table().find("inner"), std::string::npos);
}

TEST(StopSignal, TermSetsTheFlag)
{
  catch_stop_signals();
  EXPECT_FALSE(stop_requested());
  std::raise(SIGTERM);
  EXPECT_TRUE(stop_requested());
  std::signal(SIGINT, SIG_DFL);
}

TEST(RunLog, FileHoldsLinesAndWarningsButNoLiveLine)
{
  const std::string path = ::testing::TempDir() + "valsalva_log.txt";
  {
    Log log(true, path);
    log.line("step 1");
    log.live("ETA 3 s");
    log.warning("slow");
  }
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), "step 1\nwarning: slow\n");
}

TEST(OneRank, ReductionsReturnTheirArgument)
{
  const Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(comm.size(), 1);
  EXPECT_TRUE(comm.is_rank_0());
  EXPECT_EQ(comm.sum(2.5), 2.5);
  EXPECT_EQ(comm.max(-1.0), -1.0);
  EXPECT_TRUE(comm.any(true));
}

TEST(ExitCodes, FollowTheKindOfError)
{
  const Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(end_together(comm, [] { return 0; }), 0);
  EXPECT_EQ(end_together(comm, []() -> int { throw CaseError("a", "b"); }), 2);
  EXPECT_EQ(end_together(comm, []() -> int { throw SolverError("s"); }), 3);
  EXPECT_EQ(end_together(comm, []() -> int { throw IoError("i"); }), 4);
  EXPECT_EQ(end_together(comm, []() -> int { throw std::logic_error("l"); }), 1);
}

TEST(OutputFolder, IsReplacedOnlyIfForcedAndOnlyIfItHoldsARun)
{
  const Communicator comm(MPI_COMM_WORLD);
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "valsalva_out";
  std::filesystem::remove_all(folder);
  create_output_folder(folder.string(), false, "title = ''\n", comm);
  std::ofstream(folder / "old.csv") << "x";
  EXPECT_THROW(create_output_folder(folder.string(), false, "", comm), CaseError);
  EXPECT_TRUE(std::filesystem::exists(folder / "old.csv"));
  create_output_folder(folder.string(), true, "title = ''\n", comm);
  EXPECT_FALSE(std::filesystem::exists(folder / "old.csv"));
  std::filesystem::remove(folder / "case.resolved.toml");
  std::ofstream(folder / "thesis.tex") << "x";
  EXPECT_THROW(create_output_folder(folder.string(), true, "", comm), CaseError);
  EXPECT_TRUE(std::filesystem::exists(folder / "thesis.tex"));
}

TEST(OutputFolder, UsualNameIsThatOfTheCase)
{
  EXPECT_EQ(usual_output_folder("cases/aortic_root/case.toml"), "out/aortic_root");
  EXPECT_EQ(usual_output_folder("cases/aortic_root/smoke.toml"), "out/aortic_root-smoke");
}

}  // namespace valsalva::common
