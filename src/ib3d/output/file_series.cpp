#include "ib3d/output/file_series.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "common/error.hpp"
#include "common/json.hpp"
#include "common/text_file.hpp"

namespace valsalva::ib3d {

using common::Json;

FileSeries::FileSeries(std::string path) : path_(std::move(path))
{
  if (!std::filesystem::exists(path_)) return;
  std::ifstream in(path_);
  try {
    const Json series = Json::parse(in);
    series.at("file-series-version");
    for (const Json& entry : series.at("files")) entries_.push_back({entry.at("name"), entry.at("time")});
  } catch (const Json::exception&) {
    throw IoError(path_ + ": not a file series; remove it or choose another output folder");
  }
}

void FileSeries::cut_to(int count)
{
  if (static_cast<std::size_t>(count) > entries_.size())
    throw IoError(path_ + ": files that were listed at the checkpoint are missing");
  entries_.resize(static_cast<std::size_t>(count));
  if (count > 0) write();
}

void FileSeries::add(const std::string& name, double time_s)
{
  entries_.push_back({name, time_s});
  write();
}

void FileSeries::write() const
{
  Json files = Json::array();
  for (const Entry& entry : entries_) files.push_back({{"name", entry.name}, {"time", entry.time_s}});
  common::write_text_file(path_, common::json_text({{"file-series-version", "1.0"}, {"files", files}}));
}

std::string numbered_file(const std::string& stem, int number)
{
  return fmt::format("{}_{:04}.hdf", stem, number);
}

}  // namespace valsalva::ib3d
