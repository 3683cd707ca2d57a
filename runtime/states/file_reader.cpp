// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/states/file_reader.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"

namespace kanec {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;

}  // namespace

FileReader::FileReader(const std::string& path)
    : path_(path == "-" ? "/dev/stdin" : path), name_(path == "-" ? "standard input" : path) {
  file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file_ || ::fstat(file_.get(), &status) != 0) throw FileError(name_, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw FileError(name_, std::strerror(EISDIR));
  is_regular_ = S_ISREG(status.st_mode);
  if (is_regular_) size_ = static_cast<std::size_t>(status.st_size);
}

bool FileReader::fill() {
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
  const std::size_t there = buffer_.size();
  buffer_.resize(there + piece);
  ssize_t n;
  do n = ::read(file_.get(), buffer_.data() + there, piece);
  while (n < 0 && errno == EINTR);
  buffer_.resize(there + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  if (n < 0) throw FileError(name_, std::strerror(errno));
  return n > 0;
}

bool FileReader::line(std::string_view& text) {
  for (std::size_t searched = 0;;) {
    const std::string_view rest = std::string_view(buffer_).substr(begin_);
    const std::size_t end = rest.find('\n', searched);
    if (end != rest.npos) {
      text = rest.substr(0, end);
      begin_ += end + 1;
      taken_ += end + 1;
      return true;
    }
    searched = rest.size();
    if (searched > most_bytes) throw FileError(name_, "a line of more than 64 MiB");
    if (fill()) continue;
    text = std::string_view(buffer_).substr(begin_);
    begin_ = buffer_.size();
    taken_ += text.size();
    return !text.empty();
  }
}

std::string_view FileReader::bytes(std::size_t count) {
  while (buffer_.size() - begin_ < count && fill()) {
  }
  const std::string_view found = std::string_view(buffer_).substr(begin_, count);
  begin_ += found.size();
  taken_ += found.size();
  return found;
}

std::string FileReader::at(std::size_t begin, std::size_t count) const {
  std::string text(count, '\0');
  std::size_t there = 0;
  while (there < count) {
    const ssize_t n = ::pread(file_.get(), text.data() + there, count - there, static_cast<off_t>(begin + there));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(name_, std::strerror(errno));
    if (n == 0) break;
    there += static_cast<std::size_t>(n);
  }
  text.resize(there);
  return text;
}

}  // namespace kanec
