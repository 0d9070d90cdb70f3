#include "common/log.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

constexpr const char* kClearLine = "\x1b[K";

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
  if (is_root && !file.empty()) file_.emplace(file, continue_file);
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
  std::fputs(("\r" + text + kClearLine).c_str(), stdout);
  std::fflush(stdout);
  live_shown_ = true;
}

void Log::check() const
{
  if (!failure_.empty()) throw IoError(failure_);
}

void Log::write(std::FILE* terminal, const std::string& text)
{
  if (!is_root_) return;
  const std::string erase = live_shown_ ? std::string("\r") + kClearLine : "";
  live_shown_ = false;
  if (std::fputs((erase + text + '\n').c_str(), terminal) < 0 || std::fflush(terminal) != 0)
    failure_ = std::string("cannot write to the terminal: ") + std::strerror(errno);
  if (file_) try {
      file_->add(text + '\n');
      file_->flush();
    } catch (const IoError& error) {
      failure_ = error.what();
    }
}

}  // namespace valsalva::common
