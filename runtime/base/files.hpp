// Files read whole, and written whole or not at all. Not here: what stands in them.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kanec {

// The whole file. Throws FileError, also for a folder.
std::string read_file(const std::filesystem::path& path);

// A file that appears under its name only by commit(): written to a temporary name beside it, flushed to disk, renamed.
// A failure (unwritable folder, disk full) throws FileError and leaves no trace; nor does destruction without commit().
// The paths "-" and "/dev/stdout" are standard output, written as it comes; so are devices and pipes.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);  // buffered
  void commit();

 private:
  void flush();
  [[noreturn]] void fail(int error);

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::string buffer_;
  int descriptor_ = -1;
};

// AtomicFile in one call. Devices and pipes (/dev/stdout, /dev/null) are written directly, they cannot be renamed over.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace kanec
