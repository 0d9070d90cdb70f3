#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "common/checkpoint.hpp"
#include "common/error.hpp"
#include "common/vec3.hpp"

namespace valsalva::common {

namespace {

std::string file_of_this_test()
{
  const std::string path = ::testing::TempDir() + "valsalva_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".h5";
  std::filesystem::remove(path);
  return path;
}

struct Values {
  double x = 0;
  int n = 0;
  std::int64_t step = 0;
  std::string text;
  std::vector<double> list, none{1.0};
  std::vector<int> flags;
  std::vector<Vec3> points;
  bool operator==(const Values&) const = default;
  void save_or_restore(Checkpoint& c)
  {
    c("x", x);
    c("group/n", n);
    c("group/step", step);
    c("text", text);
    c("list", list);
    c("none", none);
    c("flags", flags);
    c("points", points);
  }
};

void write(const std::string& path, Values values)
{
  Checkpoint c = Checkpoint::create(path, MPI_COMM_NULL);
  values.save_or_restore(c);
  c.close();
}

}  // namespace

TEST(CheckpointFile, ValuesComeBackBitForBit)
{
  const std::string path = file_of_this_test();
  const Values before{-0.1 / 3,
                      -7,
                      std::int64_t{1} << 40,
                      "title = \"x\"\n",
                      {1e-310, std::nextafter(1.0, 2.0), -std::numeric_limits<double>::infinity()},
                      {},
                      {1, 0, 1},
                      {{1, 2, 3}, {0.1, 0.2, 0.3}}};
  write(path, before);
  Values after;
  Checkpoint c = Checkpoint::open(path, MPI_COMM_NULL);
  after.save_or_restore(c);
  EXPECT_TRUE(after == before);
}

TEST(CheckpointFile, HasItsNameOnlyOnceItIsComplete)
{
  const std::string path = file_of_this_test();
  {
    Checkpoint c = Checkpoint::create(path, MPI_COMM_NULL);
    double x = 1;
    c("x", x);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(CheckpointFile, TruncatedForeignOrLackingAValueIsRefused)
{
  const std::string path = file_of_this_test();
  write(path, {});
  {
    Checkpoint lacking = Checkpoint::open(path, MPI_COMM_NULL);
    double x = 0;
    EXPECT_THROW(lacking("absent", x), IoError);
    EXPECT_THROW(lacking("flags", x), IoError);  // no number at all
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 8);
  EXPECT_THROW(Checkpoint::open(path, MPI_COMM_NULL), IoError);
  EXPECT_THROW(Checkpoint::open(path + ".missing", MPI_COMM_NULL), IoError);
  Hdf5File other = Hdf5File::create(path);
  other.close();
  EXPECT_THROW(Checkpoint::open(path, MPI_COMM_NULL), IoError);
}

TEST(CheckpointFile, AnotherVersionOfTheFormatIsRefusedByItsNumber)
{
  const std::string path = file_of_this_test();
  Hdf5File file = Hdf5File::create(path);
  file.write_attribute("/", "format", std::string("valsalva checkpoint"));
  const std::vector<std::int64_t> version{99};
  file.write_attribute("/", "version", version);
  file.close();
  try {
    Checkpoint::open(path, MPI_COMM_NULL);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("format 99"), std::string::npos) << error.what();
  }
}

}  // namespace valsalva::common
