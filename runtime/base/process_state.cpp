// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/process_state.hpp"

#include <sstream>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"

namespace kanec {
namespace {

// /proc/<number>/stat: "number (name) state ...", where the name may hold anything; the start is its 22nd field.
std::optional<ProcessState> parse(const std::string& text) {
  const std::size_t open = text.find('('), close = text.rfind(')');
  if (open == text.npos || close == text.npos || close < open) return std::nullopt;
  ProcessState process;
  for (const char c : text.substr(open + 1, close - open - 1)) process.name += c >= ' ' && c <= '~' ? c : '?';
  std::istringstream fields(text.substr(close + 1));
  std::string state;
  fields >> state;
  for (int field = 4; field <= 22; ++field) fields >> process.start;
  if (!fields || state == "Z" || state == "X") return std::nullopt;
  process.is_stopped = state == "T" || state == "t";
  return process;
}

}  // namespace

std::optional<ProcessState> state_of_process(pid_t number) {
  if (number <= 0) return std::nullopt;
  try {
    return parse(read_file("/proc/" + std::to_string(number) + "/stat"));
  } catch (const FileError&) {
    return std::nullopt;
  }
}

}  // namespace kanec
