#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/error.hpp"
#include "common/time_series.hpp"

namespace valsalva::common {

namespace {

std::string file_of_this_test()
{
  return ::testing::TempDir() + "valsalva_" +
         ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
}

}  // namespace

TEST(TimeSeriesCsv, ReadsBackWhatWasWrittenToNineDigits)
{
  const std::string path = file_of_this_test();
  {
    TimeSeriesWriter writer(path, {"t_s", "Q_ml_s"});
    for (int i = 0; i < 20; ++i) writer.add({i * 1e-5, 412.345678912 * std::sin(0.3 * i)});
  }
  const TimeSeries series = read_time_series(path);
  ASSERT_EQ(series.row_count(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    const double exact = 412.345678912 * std::sin(0.3 * static_cast<double>(i));
    EXPECT_NEAR(series.column("Q_ml_s")[i], exact, 5e-9 * std::abs(exact));
    EXPECT_DOUBLE_EQ(series.column("t_s")[i], static_cast<double>(i) * 1e-5);
  }
  EXPECT_THROW(series.column("Q_ml"), IoError);
}

TEST(TimeSeriesCsv, ContinuedFileHoldsEveryTimeOnceAndNoTornRow)
{
  const std::string path = file_of_this_test();
  std::int64_t position = 0;
  {
    TimeSeriesWriter writer(path, {"t_s", "p_mmHg"});
    for (int i = 0; i <= 10; ++i) {
      if (i == 8) position = writer.position();
      writer.add({0.1 * i, 1.0 * i});
    }
  }
  std::ofstream(path, std::ios::app) << "1.1,1";
  {
    TimeSeriesWriter writer = TimeSeriesWriter::continue_at(path, {"t_s", "p_mmHg"}, position);
    EXPECT_EQ(writer.position(), position);
    for (int i = 8; i <= 12; ++i) writer.add({0.1 * i, -1.0 * i});
  }
  const TimeSeries series = read_time_series(path);
  ASSERT_EQ(series.row_count(), 13u);
  EXPECT_DOUBLE_EQ(series.column("p_mmHg")[7], 7.0);
  EXPECT_DOUBLE_EQ(series.column("p_mmHg")[8], -8.0);
  EXPECT_DOUBLE_EQ(series.column("t_s")[12], 1.2);
}

TEST(TimeSeriesCsv, IsNotContinuedWithOtherColumnsNorWithoutItsRows)
{
  const std::string path = file_of_this_test();
  TimeSeriesWriter(path, {"t_s", "p_mmHg"}).add({0.0, 1.0});
  EXPECT_THROW(TimeSeriesWriter::continue_at(path, {"t_s", "p_kPa"}, 11), IoError);
  EXPECT_THROW(TimeSeriesWriter::continue_at(path, {"t_s", "p_mmHg"}, 1000), IoError);
  EXPECT_THROW(TimeSeriesWriter::continue_at(path + ".missing", {"t_s"}, 3), IoError);
}

TEST(TimeSeriesCsv, BadTablesAreRefusedWithTheirLine)
{
  const std::string path = file_of_this_test();
  const auto refusal = [&](const std::string& text) -> std::string {
    std::ofstream(path) << text;
    try {
      read_time_series(path);
      return "";
    } catch (const IoError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal("# measured\nt_s, p_mmHg\r\n 0.5 , 80 \n"), "");
  EXPECT_NE(refusal("t_s,p_mmHg\n0,1\n1,high\n").find(":3: 'high' is not a number"), std::string::npos);
  EXPECT_NE(refusal("t_s,p_mmHg\n0,1,2\n").find(":2: 3 values"), std::string::npos);
  EXPECT_NE(refusal("t_s,p_mmHg\n0,\n").find("is not a number"), std::string::npos);
  EXPECT_NE(refusal(""), "");
}

TEST(TimeSeriesCsv, FileThatCannotBeWrittenIsAnError)
{
  EXPECT_THROW(TimeSeriesWriter("/no/such/folder/a.csv", {"t_s"}), IoError);
}

}  // namespace valsalva::common
