// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/error.hpp"

#include <utility>

#include "runtime/base/fit.hpp"

namespace kanec {
namespace {

std::string message(const SceneFault& fault) {
  std::string text = fault.file;
  if (fault.line > 0) text.append(":").append(std::to_string(fault.line));
  const auto append = [&text](const char* separator, const char* label, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += separator;
    text += label;
    text += part;
  };
  append(": ", "", fault.body);
  append(": ", "", fault.field);
  append(": ", "found ", fault.found);
  append("; ", "allowed: ", fault.allowed);
  return text;
}

}  // namespace

Error::Error(const std::string& message, Lines lines)
    : std::runtime_error(lines == Lines::one ? fit::line(message) : fit::lines(message)) {}

SceneError::SceneError(SceneFault fault) : Error(message(fault)), fault_(std::move(fault)) {}

FileError::FileError(const std::string& path, const std::string& cause, const std::string& output)
    : Error(fit::line(path + ": " + cause) + (output.empty() ? "" : "\n" + output), Lines::several) {}

BuildError::BuildError(const std::string& what, std::string command, std::string output)
    : Error(fit::line(what) + (command.empty() ? "" : "\n  command: " + fit::line(command)) +
                (output.empty() ? "" : "\n" + output),
            Lines::several),
      command_(std::move(command)),
      output_(std::move(output)) {}

}  // namespace kanec
