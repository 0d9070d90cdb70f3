// The lines of one text file of a fibre network: a count, then that many lines of numbers, comments removed.
// Every complaint is a CaseError with the file and line.
#pragma once

#include <string>
#include <vector>

namespace valsalva::ib3d {

class FibreFileLines {
 public:
  /// Reads `path`; each line must hold from `fewest` to `most` numbers, `columns` names them for messages.
  /// IoError if the file cannot be opened.
  FibreFileLines(std::string path, std::size_t fewest, std::size_t most, std::string columns);

  std::size_t count() const { return values_.size(); }
  std::size_t width(std::size_t line) const { return values_[line].size(); }
  double number(std::size_t line, std::size_t column) const { return values_[line][column]; }
  /// The number as an index of one of `node_count` nodes.
  int node(std::size_t line, std::size_t column, int node_count) const;
  /// The number, which `meaning` names for messages ("a spring's rest length").
  double non_negative(std::size_t line, std::size_t column, const std::string& meaning) const;

  /// Throws CaseError with file and line.
  [[noreturn]] void reject(std::size_t line, const std::string& message) const;

 private:
  void read_line(const std::string& text, int line_number, std::size_t fewest, std::size_t most,
                 const std::string& columns);
  [[noreturn]] void reject_at(int line_number, const std::string& message) const;

  std::string path_;
  std::vector<std::vector<double>> values_;
  std::vector<int> line_numbers_;
};

}  // namespace valsalva::ib3d
