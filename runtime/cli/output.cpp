// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"

namespace kanec::cli {
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

// Of what is no UTF-8, as names of files need not be, U+FFFD.
std::string dumped(const Json& json) { return fit::json(json.dump(-1, ' ', false, Json::error_handler_t::replace)); }

bool is_plain(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& part) { return part.is_structured(); });
}

std::string flat(const Json& list) {
  std::string text;
  for (const Json& part : list) text += (text.empty() ? "" : ", ") + dumped(part);
  return "[" + text + "]";
}

std::string indented(const Json& json, const std::string& margin) {
  if (!json.is_structured()) return dumped(json);
  if (json.empty()) return json.is_object() ? "{}" : "[]";
  if (json.is_array() && is_plain(json)) return flat(json);
  const std::string inner = margin + "  ";
  std::string text;
  for (const auto& [key, part] : json.items()) {
    text += (text.empty() ? "\n" : ",\n") + inner;
    if (json.is_object()) text += dumped(Json(key)) + ": ";
    text += indented(part, inner);
  }
  return (json.is_object() ? "{" : "[") + text + "\n" + margin + (json.is_object() ? "}" : "]");
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

std::string json_text(const Json& json) { return indented(json, "") + "\n"; }

void print_json(const Json& json) { print(json_text(json)); }

void remark(std::string_view text) { write_all(STDERR_FILENO, fmt::format("kanec: {}\n", fit::line(text))); }

void remark_lines(std::string_view text) { write_all(STDERR_FILENO, fmt::format("kanec: {}\n", fit::lines(text))); }

std::string brief(double value) { return fmt::format("{:.4g}", value); }

}  // namespace kanec::cli
