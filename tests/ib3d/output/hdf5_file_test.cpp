#include "common/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "ib3d/output/mpi_session.hpp"

namespace valsalva::ib3d {
namespace {

TEST(Hdf5File, InterleavedSlabsOfAllRanksMakeOneDataset)
{
  const std::string path = shared_file("slabs.h5");
  const std::int64_t ranks = mpi_size(), rank = mpi_rank();
  std::vector<Slab> rows;
  std::vector<double> values;
  for (std::int64_t row = rank; row < 3 * ranks; row += ranks) {
    rows.push_back({{row, 0}, {1, 2}});
    values.insert(values.end(), {static_cast<double>(10 * row), static_cast<double>(10 * row + 1)});
  }
  Hdf5File out = Hdf5File::create(path, MPI_COMM_WORLD);
  out.write("/a/b/rows", {3 * ranks, 2}, std::span<const Slab>(rows), std::span<const double>(values));
  out.close();

  const Hdf5File in = Hdf5File::open(path, MPI_COMM_WORLD);
  const auto all = in.read<double>("/a/b/rows");
  ASSERT_EQ(all.size(), static_cast<std::size_t>(6 * ranks));
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], static_cast<double>(10 * (i / 2) + i % 2));
  EXPECT_EQ(in.read<double>("/a/b/rows", std::span<const Slab>(rows)), values);
}

TEST(Hdf5File, AttributesReadBackBitwise)
{
  const std::string path = shared_file("attributes.h5");
  Hdf5File out = Hdf5File::create(path, MPI_COMM_WORLD);
  out.create_group("/g");
  out.write_attribute("/g", "ints", std::array<std::int64_t, 2>{-7, std::int64_t{1} << 60});
  out.write_attribute("/g", "doubles", std::array<double, 2>{0.1, 1e-300});
  out.write_attribute("/g", "text", std::string("OverlappingAMR"));
  out.close();
  const Hdf5File in = Hdf5File::open(path, MPI_COMM_WORLD);
  EXPECT_EQ(in.read_ints("/g", "ints"), (std::vector<std::int64_t>{-7, std::int64_t{1} << 60}));
  EXPECT_EQ(in.read_doubles("/g", "doubles"), (std::vector<double>{0.1, 1e-300}));
  EXPECT_EQ(in.read_text("/g", "text"), "OverlappingAMR");
}

TEST(Hdf5File, HasItsNameOnlyOnceItIsComplete)
{
  const std::string path = shared_file("complete.h5");
  std::filesystem::remove(path);
  Hdf5File out = Hdf5File::create(path, MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(std::filesystem::exists(path + ".part"));
  out.close();
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(Hdf5File, DroppedBeforeItsEndLeavesTheOldFileAndNothingElse)
{
  const std::string path = shared_file("dropped.h5");
  if (mpi_rank() == 0) std::ofstream(path) << "old";
  {
    Hdf5File out = Hdf5File::create(path, MPI_COMM_WORLD);
    const int value = 3;
    out.write("/x", {1}, std::span<const int>(&value, 1));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  std::string text;
  std::ifstream(path) >> text;
  EXPECT_EQ(text, "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(Hdf5File, ErrorOfOneRankReachesAllAndNamesPathAndDataset)
{
  const std::string path = shared_file("error.h5");
  Hdf5File out = Hdf5File::create(path, MPI_COMM_WORLD);
  const std::vector<double> values(2, 1.0);
  std::vector<Slab> slab;
  if (mpi_rank() == 0) slab.push_back({{3}, {2}});  // beyond the end
  try {
    out.write("/few", {4}, std::span<const Slab>(slab),
              std::span<const double>(values.data(), 2 * slab.size()));
    FAIL() << "a slab beyond the end was accepted";
  } catch (const IoError& e) {
    EXPECT_NE(std::string(e.what()).find(path), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("/few"), std::string::npos);
  }
}

TEST(Hdf5File, MissingFileAndMissingDatasetAreIoErrors)
{
  EXPECT_THROW(Hdf5File::open(shared_file("missing.h5")), IoError);
  EXPECT_THROW(Hdf5File::open(shared_file("missing.h5"), MPI_COMM_WORLD), IoError);
  EXPECT_THROW(Hdf5File::create(shared_file("no/such/folder/x.h5"), MPI_COMM_WORLD), IoError);
  const std::string path = shared_file("empty.h5");
  Hdf5File::create(path, MPI_COMM_WORLD).close();
  EXPECT_THROW(Hdf5File::open(path, MPI_COMM_WORLD).read<float>("/nothing"), IoError);
}

TEST(Hdf5File, WorksWithoutACommunicator)
{
  const std::string path = shared_file("serial_" + std::to_string(mpi_rank()) + ".h5");
  const std::vector<std::int64_t> values{5, 6, 7};
  Hdf5File out = Hdf5File::create(path);
  out.write("/x", {3}, std::span<const std::int64_t>(values));
  out.close();
  EXPECT_EQ(Hdf5File::open(path).read<std::int64_t>("/x"), values);
}

}  // namespace
}  // namespace valsalva::ib3d
