// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/compiler.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/process.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

// A command as it is typed.
std::string shown(const std::vector<std::string>& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "" : " ") + fit::shell(word);
  return text;
}

ProcessResult run(const std::vector<std::string>& command, const Environment& variables = {}) {
  try {
    return run_process(command, {}, variables);
  } catch (const FileError& error) {
    throw BuildError(std::string("the C++ compiler cannot be started: ") + error.what(), shown(command), "");
  }
}

struct Candidate {
  std::string text;
  std::string origin;  // " ($CXX)"
};

struct Candidates {
  std::vector<Candidate> list;
  bool exclusive = false;  // asked for by name: nothing else will do
};

Candidates candidates(const std::string& wish, Code code) {
  if (!wish.empty()) return {{{wish, ""}}, true};
  if (const std::string own = variable("KANEC_CXX"); !own.empty()) return {{{own, " ($KANEC_CXX)"}}, true};
  Candidates all;
  if (const std::string cxx = variable("CXX"); !cxx.empty()) all.list.push_back({cxx, " ($CXX)"});
  std::vector<std::string> usual = {"clang++", "c++", "g++"};
  if (code == Code::lanes) std::reverse(usual.begin(), usual.end());
  for (const std::string& name : usual) all.list.push_back({name, ""});
  return all;
}

// The program with its arguments; a path with blanks in it is tried as it stands first.
std::optional<Compiler> locate(const std::string& text) {
  if (const auto path = find_program(text)) return Compiler{*path, {}, ""};
  std::vector<std::string> parts = words(text);
  if (parts.size() < 2) return std::nullopt;
  const auto path = find_program(parts[0]);
  if (!path) return std::nullopt;
  parts.erase(parts.begin());
  return Compiler{*path, std::move(parts), ""};
}

std::vector<std::string> command_of(const Compiler& compiler) {
  std::vector<std::string> command = {compiler.path.string()};
  command.insert(command.end(), compiler.arguments.begin(), compiler.arguments.end());
  return command;
}

}  // namespace

std::string version_of(const Compiler& compiler) {
  std::vector<std::string> command = command_of(compiler);
  command.push_back("--version");
  const ProcessResult result = run(command);
  if (result.status == 0) return result.output;
  throw BuildError("the C++ compiler does not tell its version: status " + std::to_string(result.status),
                   shown(command), result.output);
}

Compiler find_compiler(const std::string& wish, Code code) {
  Compiler compiler = locate_compiler(wish, code);
  compiler.version = version_of(compiler);
  return compiler;
}

Compiler locate_compiler(const std::string& wish, Code code) {
  const Candidates all = candidates(wish, code);
  std::string tried;
  for (const Candidate& candidate : all.list) {
    if (const auto compiler = locate(candidate.text)) return *compiler;
    tried += (tried.empty() ? "" : ", ") + candidate.text + candidate.origin;
  }
  const std::string remedy = all.exclusive ? "" : "; install one (Debian: apt install g++) or name one in KANEC_CXX";
  throw BuildError("no C++ compiler found; tried " + tried + remedy, "", "");
}

std::vector<std::string> default_flags() {
  if (const char* flags = std::getenv("KANEC_CXXFLAGS")) return words(flags);
  // g++ 12 packs scalars of straight-line code into vectors at a loss: residual of six bodies 222 ns with, 123 ns
  // without
  return {"-O2", "-march=native", "-fno-math-errno", "-fno-tree-slp-vectorize"};
}

std::vector<std::string> command_line(const Compiler& compiler, const std::vector<std::string>& flags,
                                      const fs::path& main, const fs::path& library) {
  std::vector<std::string> command = command_of(compiler);
  for (const char* flag : {"-std=c++17", "-fPIC", "-shared", "-fvisibility=hidden"}) command.push_back(flag);
  command.insert(command.end(), flags.begin(), flags.end());
  for (const std::string& part : {main.string(), std::string("-o"), library.string()}) command.push_back(part);
  return command;
}

double make_library(const std::vector<std::string>& command, const fs::path& library, const fs::path& temporary) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult result = run(command, {{"TMPDIR", fs::absolute(temporary).string()}});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (result.status != 0)
    throw BuildError("the C++ compiler ended with status " + std::to_string(result.status), shown(command),
                     result.output);
  std::error_code ignored;
  if (!fs::is_regular_file(library, ignored))
    throw BuildError("the C++ compiler made no library", shown(command), result.output);
  return seconds.count();
}

}  // namespace kanec::compile
