#include "common/log.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

/// mpirun hands rank 0 a terminal of its own even where its output goes to a file, so under mpirun only its caller
/// knows: scripts/run sets VALSALVA_LIVE.
bool output_is_a_terminal()
{
  if (isatty(STDOUT_FILENO) != 1) return false;
  return std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr || std::getenv("VALSALVA_LIVE") != nullptr;
}

}  // namespace

Log::Log(bool is_root, const std::string& file, bool continue_file)
    : is_root_(is_root), is_terminal_(is_root && output_is_a_terminal())
{
  if (!is_root || file.empty()) return;
  file_.reset(std::fopen(file.c_str(), continue_file ? "a" : "w"));
  if (!file_)
    throw IoError("cannot write the log '" + file + "'; check that the folder exists and may be written");
}

void Log::line(const std::string& text)
{
  write(stdout, text);
}

void Log::warning(const std::string& text)
{
  write(stderr, "warning: " + text);
}

void Log::live(const std::string& text)
{
  if (!is_terminal_) return;
  fmt::print("\r{}\x1b[K", text);
  std::fflush(stdout);
  live_shown_ = true;
}

void Log::write(std::FILE* terminal, const std::string& text)
{
  if (!is_root_) return;
  if (live_shown_) fmt::print("\r\x1b[K");
  live_shown_ = false;
  fmt::print(terminal, "{}\n", text);
  std::fflush(terminal);
  if (!file_) return;
  fmt::print(file_.get(), "{}\n", text);
  std::fflush(file_.get());
}

}  // namespace valsalva::common
