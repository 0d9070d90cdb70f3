#include "ib3d/output/file_series.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>
#include <utility>

#include "common/error.hpp"

namespace valsalva::ib3d {

FileSeries::FileSeries(std::string path) : path_(std::move(path))
{
  if (!std::filesystem::exists(path_)) return;
  std::ifstream in(path_);
  const std::regex entry(R"re(\{ "name" : "([^"]+)", "time" : ([^ ]+) \})re");
  bool recognised = false;
  for (std::string line; std::getline(in, line);) {
    std::smatch found;
    if (line.find("file-series-version") != std::string::npos) recognised = true;
    if (std::regex_search(line, found, entry)) entries_.push_back({found[1], std::stod(found[2])});
  }
  if (!recognised) throw IoError(path_ + ": not a file series; remove it or choose another output folder");
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
  const std::string part = path_ + ".part";
  {
    std::ofstream out(part);
    out << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n";
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      out << fmt::format("    {{ \"name\" : \"{}\", \"time\" : {} }}{}\n", entries_[i].name,
                         entries_[i].time_s, i + 1 < entries_.size() ? "," : "");
    }
    out << "  ]\n}\n";
    out.close();
    if (!out) throw IoError(part + ": could not be written");
  }
  std::error_code failed;
  std::filesystem::rename(part, path_, failed);
  if (failed) throw IoError(path_ + ": could not be renamed from " + part + " (" + failed.message() + ")");
}

std::string numbered_file(const std::string& stem, int number)
{
  return fmt::format("{}_{:04}.hdf", stem, number);
}

}  // namespace valsalva::ib3d
