// Traces over time as CSV: a header of names that end in their units ("t_s,p_ao_mmHg"), one row per time,
// nine significant digits. The first column is the time. Rows reach the disk every few seconds and at the
// end.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/text_file.hpp"

namespace valsalva::common {

class TimeSeriesWriter {
 public:
  /// Creates the file with its header. IoError if it cannot be written.
  TimeSeriesWriter(const std::string& path, std::vector<std::string> columns);
  /// Opens a file of an earlier run, cuts off what was written after `position()` was asked, and goes on there.
  /// IoError if the columns are not the same or rows are missing.
  static TimeSeriesWriter continue_at(const std::string& path, std::vector<std::string> columns,
                                      std::int64_t position);

  /// One row; `values` has one entry per column, or one less if the last column holds words. IoError if the disk is
  /// full: the file then ends with the last row that reached it.
  void add(const std::vector<double>& values, const std::string& word = "");
  void flush();
  /// Where the next row begins (bytes); all rows before it are on the disk.
  std::int64_t position();

 private:
  TimeSeriesWriter(const std::string& path, std::size_t column_count, bool keep_old);
  GrowingFile file_;
  std::size_t column_count_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

struct TimeSeries {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< [column][row]
  std::size_t row_count() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The column of this name; IoError with the known names if there is none.
  const std::vector<double>& column(std::string_view name) const;
};

/// Reads a CSV of numbers with a header line; lines that begin with # are skipped. IoError with file and line
/// if something is not a number or a row has another length.
TimeSeries read_time_series(const std::string& path);

}  // namespace valsalva::common

namespace valsalva {
using common::TimeSeries;
using common::TimeSeriesWriter;
}  // namespace valsalva
