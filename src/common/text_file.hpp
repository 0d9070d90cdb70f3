// Text files that a full disk does not spoil. Every failure is an IoError with the file's name and the
// system's reason: "cannot write 'out/step.csv': No space left on device".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace valsalva::common {

/// Replaces `path` by `text` as a whole: written under the name path + ".part" and renamed, so that `path`
/// holds the old text or the new one.
void write_text_file(const std::string& path, std::string_view text);

/// Sets `bytes` of the disk aside, in path + ".part", for the next `write_text_file` of `path`.
void reserve_text_file(const std::string& path, std::size_t bytes);

/// A file that grows by whole texts: what a full disk cuts off is taken back to the last flush.
class GrowingFile {
 public:
  /// Begins anew, or behind what is there.
  explicit GrowingFile(std::string path, bool keep_old = false);
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&& other) noexcept;
  ~GrowingFile();  ///< flushes; a failure then has no voice

  const std::string& path() const { return path_; }
  void add(std::string_view text) { waiting_ += text; }
  void flush();
  /// Flushes, waits for the disk and returns the length.
  std::int64_t sync();

 private:
  std::string path_, waiting_;
  int file_;
  std::int64_t length_;
};

}  // namespace valsalva::common
