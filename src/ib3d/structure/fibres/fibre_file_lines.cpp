#include "ib3d/structure/fibres/fibre_file_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "common/error.hpp"

namespace valsalva::ib3d {

namespace {

std::string without_comment(const std::string& line)
{
  return line.substr(0, std::min(line.find('#'), line.find("//")));
}

std::vector<std::string> words_of(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool parse(const std::string& word, double& value)
{
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0' && std::isfinite(value);
}

}  // namespace

FibreFileLines::FibreFileLines(std::string path, std::size_t fewest, std::size_t most, std::string columns)
    : path_(std::move(path))
{
  std::ifstream file(path_);
  if (!file) throw IoError(fmt::format("{}: cannot be opened for reading.", path_));
  double count = -1.0;
  int count_line = 0, line_number = 0;
  for (std::string raw; std::getline(file, raw);) {
    ++line_number;
    const std::string text = without_comment(raw);
    const std::vector<std::string> words = words_of(text);
    if (words.empty()) continue;
    if (count_line == 0) {
      if (words.size() != 1 || !parse(words[0], count) || count < 0.0 || count != std::floor(count))
        reject_at(
            line_number,
            fmt::format("found \"{}\", but the first line must be the number of lines to follow.", text));
      count_line = line_number;
    } else {
      if (static_cast<double>(values_.size()) == count)
        reject_at(line_number,
                  fmt::format("found more than the {:.0f} lines that line {} announces.", count, count_line));
      read_line(text, line_number, fewest, most, columns);
    }
  }
  if (count_line == 0) reject_at(1, "the file is empty, but its first line must be a count.");
  if (static_cast<double>(values_.size()) != count)
    reject_at(count_line, fmt::format("{:.0f} lines are announced, but {} follow.", count, values_.size()));
  if (file.bad()) throw IoError(fmt::format("{}: reading failed.", path_));
}

void FibreFileLines::read_line(const std::string& text, int line_number, std::size_t fewest, std::size_t most,
                               const std::string& columns)
{
  const std::vector<std::string> words = words_of(text);
  if (words.size() < fewest || words.size() > most)
    reject_at(line_number, fmt::format("found {} entries, but a line must read: {}.", words.size(), columns));
  std::vector<double> numbers;
  for (const std::string& word : words) {
    double value = 0.0;
    if (!parse(word, value)) reject_at(line_number, fmt::format("\"{}\" is not a finite number.", word));
    numbers.push_back(value);
  }
  values_.push_back(std::move(numbers));
  line_numbers_.push_back(line_number);
}

int FibreFileLines::node(std::size_t line, std::size_t column, int node_count) const
{
  const double value = number(line, column);
  if (value < 0.0 || value >= node_count || value != std::floor(value))
    reject(line, fmt::format("found node {:.17g}, but nodes are numbered 0 to {}.", value, node_count - 1));
  return static_cast<int>(value);
}

double FibreFileLines::non_negative(std::size_t line, std::size_t column, const std::string& meaning) const
{
  const double value = number(line, column);
  if (value < 0.0)
    reject(line, fmt::format("found a {} of {:.6g}, but it must not be negative.", meaning, value));
  return value;
}

void FibreFileLines::reject(std::size_t line, const std::string& message) const
{
  reject_at(line_numbers_[line], message);
}

void FibreFileLines::reject_at(int line_number, const std::string& message) const
{
  throw CaseError(std::vector<CaseProblem>{CaseProblem{path_, line_number, 1, "", message}});
}

}  // namespace valsalva::ib3d
