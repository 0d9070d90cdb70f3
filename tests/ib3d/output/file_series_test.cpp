#include "ib3d/output/file_series.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "common/error.hpp"
#include "ib3d/output/mpi_session.hpp"

namespace valsalva::ib3d {
namespace {

std::string own_file(const std::string& name)
{
  const std::string path = shared_file(std::to_string(mpi_rank()) + name);
  std::filesystem::remove(path);
  return path;
}

TEST(FileSeries, IsTheJsonThatParaViewReads)
{
  const std::string path = own_file("fields.hdf.series");
  FileSeries series(path);
  series.add(numbered_file("fields", 0), 0.0);
  series.add(numbered_file("fields", 1), 0.0125);
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), R"({
  "file-series-version": "1.0",
  "files": [
    {
      "name": "fields_0000.hdf",
      "time": 0.0
    },
    {
      "name": "fields_0001.hdf",
      "time": 0.0125
    }
  ]
}
)");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(FileSeries, ContinuedRunReplacesTheEntriesAfterItsCheckpoint)
{
  const std::string path = own_file("leaflets.hdf.series");
  for (int n = 0; n < 4; ++n) FileSeries(path).add(numbered_file("leaflets", n), 0.1 * n);
  FileSeries series(path);
  series.cut_to(2);
  series.add(numbered_file("leaflets", 2), 0.1 * 2);
  EXPECT_THROW(series.cut_to(4), IoError);
  ASSERT_EQ(series.entries().size(), 3U);
  EXPECT_EQ(series.entries()[1].time_s, 0.1);
  EXPECT_EQ(series.entries()[2].name, "leaflets_0002.hdf");
  EXPECT_EQ(FileSeries(path).entries()[2].time_s, 0.1 * 2);
}

TEST(FileSeries, RefusesAFileThatIsSomethingElse)
{
  const std::string path = own_file("other.series");
  for (const char* text :
       {"precious\n", "{}", R"({"file-series-version": "1.0", "files": [{"name": "x"}]})"}) {
    std::ofstream(path) << text;
    EXPECT_THROW(FileSeries{path}, IoError) << text;
  }
}

}  // namespace
}  // namespace valsalva::ib3d
