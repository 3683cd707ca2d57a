// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/key.hpp"

#include <sys/stat.h>
#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "kanec_abi_text.hpp"
#include "runtime/abi/abi.h"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

// Name, length, value: with the length no value can pass for the next field.
void add(std::string& key, const std::string& name, std::string_view value) {
  key.append(name).append(" ").append(std::to_string(value.size())).append("\n").append(value).append("\n");
}

// Of x86, ARM, POWER, RISC-V and s390.
constexpr std::array<std::string_view, 17> lasting_lines = {
    "vendor_id", "cpu family",  "model",    "model name", "stepping", "flags", "CPU implementer", "CPU architecture",
    "CPU part",  "CPU variant", "Features", "cpu",        "isa",      "mmu",   "uarch",           "features",
    "mvendorid"};

// Machine and processor; where the system does not describe its processors, this one machine.
std::string machine() {
  utsname system{};
  ::uname(&system);
  std::string text = std::string(system.machine) + "\n";
  std::string kind;
  try {
    kind = processor(read_file("/proc/cpuinfo"));
  } catch (const FileError&) {
  }
  return text + (kind.empty() ? system.nodename : kind);
}

}  // namespace

std::string file_behind(const fs::path& path) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  struct stat status {};
  if (failed || ::stat(real.c_str(), &status) != 0) return path.string();
  return real.string() + " " + std::to_string(status.st_size) + " " + std::to_string(status.st_mtim.tv_sec) + "." +
         std::to_string(status.st_mtim.tv_nsec);
}

std::string processor(std::string_view cpuinfo) {
  const std::string_view first = cpuinfo.substr(0, cpuinfo.find("\n\n"));
  std::string kept;
  for (std::size_t begin = 0; begin < first.size();) {
    const std::size_t end = std::min(first.find('\n', begin), first.size());
    const std::string_view line = first.substr(begin, end - begin);
    std::string_view name = line.substr(0, line.find(':'));
    while (!name.empty() && (name.back() == '\t' || name.back() == ' ')) name.remove_suffix(1);
    if (std::find(lasting_lines.begin(), lasting_lines.end(), name) != lasting_lines.end())
      kept.append(line).append("\n");
    begin = end + 1;
  }
  return kept;
}

std::string cache_key(const Source& source, const Compiler& compiler, const std::vector<std::string>& flags) {
  std::string key;
  add(key, "abi", std::to_string(KANEC_ABI_VERSION));
  add(key, "name", source.name);
  add(key, "sizes", std::to_string(source.nx) + " " + std::to_string(source.ny));
  add(key, "compiler", compiler.path.string());
  for (const std::string& argument : compiler.arguments) add(key, "argument", argument);
  add(key, "file", file_behind(compiler.path));
  add(key, "version", compiler.version);
  const std::vector<std::string> command = command_line(compiler, flags, source.main, "");
  for (const std::string& word : command) add(key, "word", word);
  for (const char* name :
       {"CPATH", "CPLUS_INCLUDE_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX", "LIBRARY_PATH", "CCC_OVERRIDE_OPTIONS"})
    if (const char* value = std::getenv(name)) add(key, name, value);
  add(key, "machine", machine());
  add(key, "abi.h", abi_text);
  if (source.files.empty()) {
    add(key, "origin", source.origin);
    return key;
  }
  add(key, "hash", source.hash);
  for (const auto& [name, text] : source.files) add(key, name, text);
  return key;
}

}  // namespace kanec::compile
