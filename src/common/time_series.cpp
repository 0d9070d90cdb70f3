#include "common/time_series.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "common/error.hpp"
#include "common/nearest_name.hpp"

namespace valsalva::common {

namespace {

constexpr double kFlushInterval_s = 3.0;

std::vector<std::string> split_row(const std::string& line)
{
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::size_t first = line.find_first_not_of(" \t\r", begin);
    const std::size_t last = end > begin ? line.find_last_not_of(" \t\r", end - 1) : std::string::npos;
    const bool blank = first == std::string::npos || first >= end || last == std::string::npos;
    cells.push_back(blank ? "" : line.substr(first, last + 1 - first));
    begin = end + 1;
  }
  return cells;
}

std::string header_of(const std::vector<std::string>& columns)
{
  return fmt::format("{}\n", fmt::join(columns, ","));
}

}  // namespace

TimeSeriesWriter::TimeSeriesWriter(const std::string& path, std::size_t column_count, bool keep_old)
    : file_(path, keep_old), column_count_(column_count)
{
}

TimeSeriesWriter::TimeSeriesWriter(const std::string& path, std::vector<std::string> columns)
    : TimeSeriesWriter(path, columns.size(), false)
{
  file_.add(header_of(columns));
  flush();
}

TimeSeriesWriter TimeSeriesWriter::continue_at(const std::string& path, std::vector<std::string> columns,
                                               std::int64_t position)
{
  std::ifstream old(path);
  std::string line;
  if (!old || !std::getline(old, line))
    throw IoError("cannot continue '" + path + "': it is not there or empty");
  if (line + "\n" != header_of(columns))
    throw IoError("cannot continue '" + path + "': its columns are not those of this run");
  std::error_code failed;
  if (std::filesystem::file_size(path) < static_cast<std::uintmax_t>(position))
    throw IoError("cannot continue '" + path + "': rows that were there at the checkpoint are missing");
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(position), failed);
  if (failed) throw IoError("cannot cut '" + path + "' back to the checkpoint: " + failed.message());
  return TimeSeriesWriter(path, columns.size(), true);
}

void TimeSeriesWriter::add(const std::vector<double>& values, const std::string& word)
{
  if (values.size() + (word.empty() ? 0 : 1) != column_count_)
    throw std::logic_error(
        fmt::format("{}: {} values for {} columns", file_.path(), values.size(), column_count_));
  file_.add(fmt::format("{:.9g}{}{}\n", fmt::join(values, ","), word.empty() ? "" : ",", word));
  const auto now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - flushed_).count() > kFlushInterval_s) flush();
}

void TimeSeriesWriter::flush()
{
  file_.flush();
  flushed_ = std::chrono::steady_clock::now();
}

std::int64_t TimeSeriesWriter::position()
{
  return file_.sync();
}

const std::vector<double>& TimeSeries::column(std::string_view name) const
{
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return columns[i];
  throw IoError(
      fmt::format("no column '{}' among {}{}", name, fmt::join(names, ", "), did_you_mean(name, names)));
}

TimeSeries read_time_series(const std::string& path)
{
  std::ifstream stream(path);
  if (!stream) throw IoError("cannot read '" + path + "'; check the path and its permissions");
  TimeSeries series;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r" || line[0] == '#') continue;
    const std::vector<std::string> cells = split_row(line);
    if (series.names.empty()) {
      series.names = cells;
      series.columns.resize(cells.size());
      continue;
    }
    if (cells.size() != series.names.size())
      throw IoError(fmt::format("{}:{}: {} values in a row, the header names {}", path, number, cells.size(),
                                series.names.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      char* end = nullptr;
      series.columns[i].push_back(std::strtod(cells[i].c_str(), &end));
      if (cells[i].empty() || *end != '\0')
        throw IoError(fmt::format("{}:{}: '{}' is not a number", path, number, cells[i]));
    }
  }
  if (series.names.empty())
    throw IoError("'" + path + "' is empty; a CSV begins with the names of its columns");
  return series;
}

}  // namespace valsalva::common
