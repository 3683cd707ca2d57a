// The errors of kanec: one base class, one class a cause. Not here: how they are shown (runtime/cli).
// Everything, also std-only stages, may include this. Messages may hold what strangers chose: they are made fit here.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace kanec {

// Base of all errors; what() is the whole message for a person, fit for a terminal and valid UTF-8: one line but where
// another program's words stand in it.
class Error : public std::runtime_error {
 public:
  enum class Lines { one, several };
  explicit Error(const std::string& message, Lines lines = Lines::one);
};

// Where in a scene something is wrong, and what would be right. Empty or zero parts are left out of the message.
struct SceneFault {
  std::string file;
  int line = 0;         // 1-based; 0 = unknown
  std::string body;     // "body 3 (arm)"
  std::string field;    // "mass", "r[2]"
  std::string found;    // what stands there
  std::string allowed;  // what may stand there
};

// A scene that cannot be understood or modelled. Message: "file:line: body 3 (arm): mass: found -1; allowed: ...".
class SceneError : public Error {
 public:
  explicit SceneError(SceneFault fault);
  const SceneFault& fault() const { return fault_; }

 private:
  SceneFault fault_;
};

// An argument or an input file of a command that cannot be used.
class InputError : public Error {
 public:
  using Error::Error;
};

// A file that cannot be read or written; the message names path and cause, and what another program said about it.
class FileError : public Error {
 public:
  FileError(const std::string& path, const std::string& cause, const std::string& output = "");
};

// No compiler, or one that fails; carries its command line, as it is typed into a shell, and its output.
class BuildError : public Error {
 public:
  BuildError(const std::string& what, std::string command, std::string output);
  const std::string& command() const { return command_; }
  const std::string& output() const { return output_; }

 private:
  std::string command_;
  std::string output_;
};

// A compiled model that cannot be loaded or that is of another version, model or size.
class LoadError : public Error {
 public:
  using Error::Error;
};

// An integration that cannot go on; the message names the time and the cause.
class IntegrationError : public Error {
 public:
  using Error::Error;
};

// A mistake in kanec itself.
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace kanec
