// What a run tells its user: lines on the terminal and, without the live progress line, in log.txt. Only rank
// 0 prints; on other ranks every call does nothing.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "common/text_file.hpp"

namespace valsalva::common {

class Log {
 public:
  /// Silent on ranks other than 0. Without a `file` (empty path) only the terminal is written; IoError if the
  /// file cannot be created. A line that cannot be written is no error yet: `check` throws it, where ranks agree.
  explicit Log(bool is_root, const std::string& file = "", bool continue_file = false);

  void line(const std::string& text);
  void warning(const std::string& text);
  /// A line that replaces itself where the output is a terminal, and is left out elsewhere.
  void live(const std::string& text);
  /// IoError if a line could not be written.
  void check() const;

 private:
  void write(std::FILE* terminal, const std::string& text);
  bool is_root_;
  bool is_terminal_;
  bool live_shown_ = false;
  std::optional<GrowingFile> file_;
  std::string failure_;
};

}  // namespace valsalva::common

namespace valsalva {
using common::Log;
}  // namespace valsalva
