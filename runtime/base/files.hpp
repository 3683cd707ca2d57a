// Files read whole, and written whole or not at all. Not here: what stands in them.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace kanec {

constexpr std::size_t most_bytes = std::size_t{64} << 20;      // of what a person writes
constexpr std::size_t most_of_a_table = std::size_t{4} << 30;  // of rows that a run wrote
constexpr std::size_t any_size = std::size_t(-1);              // of what was made here

// The whole file. Throws FileError, also for a folder, and for more than `most` bytes; of devices and pipes, which may
// have no end, for more than most_bytes in any case.
std::string read_file(const std::filesystem::path& path, std::size_t most = most_bytes);

// The system's folder for temporary files, absolute, so that its name is no option of a program that it is handed to;
// /tmp where the one that is set is none.
std::filesystem::path temporary_root();

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
