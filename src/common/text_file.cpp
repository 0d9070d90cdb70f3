#include "common/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

/// With the reason of the system call that has just failed.
IoError failure(const std::string& path)
{
  const std::string reason = std::strerror(errno);
  return IoError("cannot write '" + path + "': " + reason);
}

bool write_all(int file, std::string_view text)
{
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Without O_TRUNC, so that blocks set aside are kept.
void write_part(const std::string& path, std::string_view text)
{
  const std::string part = path + ".part";
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw failure(path);
  const bool written = write_all(file, text) && ::ftruncate(file, static_cast<off_t>(text.size())) == 0;
  const int reason = errno;
  if (::close(file) == 0 && written) return;
  if (!written) errno = reason;
  const IoError error = failure(path);
  std::remove(part.c_str());
  throw error;
}

}  // namespace

void write_text_file(const std::string& path, std::string_view text)
{
  write_part(path, text);
  if (std::rename((path + ".part").c_str(), path.c_str()) != 0) throw failure(path);
}

void reserve_text_file(const std::string& path, std::size_t bytes)
{
  write_part(path, std::string(bytes, ' '));
}

GrowingFile::GrowingFile(std::string path, bool keep_old)
    : path_(std::move(path)),
      file_(
          ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (keep_old ? 0 : O_TRUNC), 0666)),
      length_(file_ < 0 ? 0 : ::lseek(file_, 0, SEEK_END))
{
  if (file_ < 0) throw failure(path_);
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)),
      waiting_(std::exchange(other.waiting_, {})),
      file_(std::exchange(other.file_, -1)),
      length_(other.length_)
{
}

GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept
{
  std::swap(path_, other.path_);
  std::swap(waiting_, other.waiting_);
  std::swap(file_, other.file_);
  std::swap(length_, other.length_);
  return *this;
}

GrowingFile::~GrowingFile()
{
  if (file_ < 0) return;
  try {
    flush();
  } catch (const IoError&) {
  }
  ::close(file_);
}

void GrowingFile::flush()
{
  const std::string text = std::exchange(waiting_, {});
  if (write_all(file_, text)) {
    length_ += static_cast<std::int64_t>(text.size());
    return;
  }
  const int reason = errno;
  [[maybe_unused]] const int cut = ::ftruncate(file_, length_);
  errno = reason;
  throw failure(path_);
}

std::int64_t GrowingFile::sync()
{
  flush();
  if (::fsync(file_) != 0) throw failure(path_);
  return length_;
}

}  // namespace valsalva::common
