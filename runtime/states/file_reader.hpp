// A file or standard input read bit by bit, as bytes or as lines. Not: what stands in it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/base/descriptor.hpp"

namespace kanec {

class FileReader {
 public:
  // "-": standard input. Throws FileError, also for a folder.
  explicit FileReader(const std::string& path);

  // The next line, without its end; the view holds until the next call. False at the end. Throws FileError for a line
  // of more than 64 MiB.
  bool line(std::string_view& text);
  // The next so many bytes, or fewer at the end; the view holds until the next call.
  std::string_view bytes(std::size_t count);
  // So many bytes from there; only of a file. Does not move where line() and bytes() go on.
  std::string at(std::size_t begin, std::size_t count) const;

  bool is_regular() const { return is_regular_; }
  std::size_t size() const { return size_; }  // of a regular file, when it was opened
  // How much of it was read, 0 to 1; 0 where its size is not known.
  double share() const { return size_ == 0 ? 0.0 : static_cast<double>(taken_) / static_cast<double>(size_); }
  const std::string& name() const { return name_; }  // as messages have it

 private:
  bool fill();  // more behind what is there; false at the end

  std::string path_, name_;
  Descriptor file_;
  bool is_regular_ = false;
  std::size_t size_ = 0, taken_ = 0;
  std::string buffer_;
  std::size_t begin_ = 0;  // of what is not yet handed out
};

}  // namespace kanec
