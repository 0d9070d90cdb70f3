#include "common/text_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "common/time_series.hpp"

namespace valsalva::common {

namespace {

namespace fs = std::filesystem;

std::string scratch(const std::string& name)
{
  return (fs::path(::testing::TempDir()) / name).string();
}

std::string text_of(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

template <class Action>
std::string failure_of(Action&& action)
{
  try {
    action();
  } catch (const IoError& error) {
    return error.what();
  }
  return "no IoError";
}

/// No file of this process may grow beyond `bytes`, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &now);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(TextFile, AFullDiskLeavesTheOldTextAndIsNamed)
{
  const std::string path = scratch("record.json");
  write_text_file(path, "the old text");
  const FullDisk disk(20);
  EXPECT_EQ(failure_of([&] { write_text_file(path, std::string(30, 'x')); }),
            "cannot write '" + path + "': File too large");
  EXPECT_EQ(text_of(path), "the old text");
  EXPECT_FALSE(fs::exists(path + ".part"));
}

TEST(TextFile, WhatWasSetAsideIsUsedByTheNextText)
{
  const std::string path = scratch("reserved.json");
  reserve_text_file(path, 1000);
  EXPECT_EQ(fs::file_size(path + ".part"), 1000U);
  write_text_file(path, "short");
  EXPECT_EQ(text_of(path), "short");
  EXPECT_FALSE(fs::exists(path + ".part"));
}

TEST(GrowingFile, WhatAFullDiskCutsOffIsTakenBackToTheLastFlush)
{
  const std::string path = scratch("growing.txt");
  GrowingFile file(path);
  file.add("twenty characters...");
  file.flush();
  {
    const FullDisk disk(30);
    file.add("twenty more.........");
    EXPECT_EQ(failure_of([&] { file.flush(); }), "cannot write '" + path + "': File too large");
  }
  EXPECT_EQ(text_of(path), "twenty characters...");
}

TEST(TimeSeriesWriter, OnAFullDiskTheLastRowIsWholeAndTheErrorNamesTheFile)
{
  const std::string path = scratch("full.csv");
  TimeSeriesWriter writer(path, {"t_s", "p_mmHg"});
  writer.add({0.0, 1.0});
  writer.flush();
  {
    const FullDisk disk(22);
    writer.add({0.125, 2.5});
    EXPECT_EQ(failure_of([&] { writer.flush(); }), "cannot write '" + path + "': File too large");
  }
  EXPECT_EQ(text_of(path), "t_s,p_mmHg\n0,1\n");
}

TEST(GrowingFile, ADeviceThatIsFullIsAnIoError)
{
  GrowingFile file("/dev/full", true);
  file.add("x");
  EXPECT_EQ(failure_of([&] { file.flush(); }), "cannot write '/dev/full': No space left on device");
}

}  // namespace

}  // namespace valsalva::common
