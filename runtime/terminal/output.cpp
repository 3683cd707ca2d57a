// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/terminal/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"

namespace kanec {
namespace {

// Open for the direction in which nobody uses it: reading input and writing output fail, remarks go nowhere.
constexpr int stand_in[] = {O_WRONLY, O_RDONLY, O_WRONLY};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

void guard_standard_streams() {
  for (int descriptor = 0; descriptor < 3; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", stand_in[descriptor]);
}

void print(std::string_view text) {
  if (!write_all(STDOUT_FILENO, text)) throw FileError("standard output", std::strerror(errno));
}

bool is_standard_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

void report(std::string_view text, bool output_is_taken) {
  if (output_is_taken)
    write_all(STDERR_FILENO, text);
  else
    print(text);
}

void print_json(const Json& json) { print(json_text(json)); }

void remark(std::string_view text) { write_all(STDERR_FILENO, fmt::format("kanec: {}\n", fit::line(text))); }

void remark_lines(std::string_view text) { write_all(STDERR_FILENO, fmt::format("kanec: {}\n", fit::lines(text))); }

}  // namespace kanec
