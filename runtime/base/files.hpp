// Files read whole, and written whole or not at all, one by one or several together. Not here: what stands in them.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/descriptor.hpp"

namespace kanec {

constexpr std::size_t most_bytes = std::size_t{64} << 20;      // of what a person writes
constexpr std::size_t most_of_a_table = std::size_t{4} << 30;  // of rows that a run wrote
constexpr std::size_t any_size = std::size_t(-1);              // of what was made here

// The whole file. Throws FileError, also for a folder, and for more than `most` bytes; of devices and pipes, which may
// have no end, for more than most_bytes in any case.
std::string read_file(const std::filesystem::path& path, std::size_t most = most_bytes);

// A file that appears under its name only by commit(): written to a temporary name beside it, flushed to disk, renamed.
// A failure (unwritable folder, disk full) throws FileError and leaves no trace; nor does destruction without commit().
// What a killed process leaves is cleared away when the next file is written into that folder. Symbolic links are
// written through, whether there is a file behind them or not; other names of the file (hard links) keep what it held.
// The paths "-" and "/dev/stdout" are standard output, written as it comes; so are devices, pipes and open descriptors
// (/dev/stderr, /dev/fd/3).
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);  // buffered
  void flush();                       // on the disk, under the temporary name still
  void commit();

 private:
  friend void commit_all(std::span<AtomicFile* const> files);
  enum class Stage { open, created, exchanged, replaced };

  void open_direct(Descriptor descriptor);
  void open_place();
  void put_out();
  void place(bool can_be_taken_back);
  void take_back();
  void finish();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;       // as it was given
  std::filesystem::path place_;      // where its links lead
  std::filesystem::path temporary_;  // empty where it is written directly
  std::string buffer_;
  Descriptor file_;
  Stage stage_ = Stage::open;
};

// All of them appear, or, where one cannot, none: those that are in place already are put back as they were, as far as
// the file system can exchange two files. Throws FileError.
void commit_all(std::span<AtomicFile* const> files);

// AtomicFile in one call. Devices and pipes (/dev/stdout, /dev/null) are written directly, they cannot be renamed over.
void write_file(const std::filesystem::path& path, std::string_view text);

// Whether what is written to these two goes to one file, which need not be there yet; an empty path is no file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace kanec
