// The system's C++ compiler: found, asked for its version, run. Not: what is compiled, or whether it needs to be.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kanec::compile {

struct Compiler {
  std::filesystem::path path;
  std::vector<std::string> arguments;  // that belong to it: "g++" of "ccache g++"
  std::string version;                 // what it answers to --version
};

// What is compiled: scalar code, which clang++ compiles faster and no slower to run, or lanes, which g++ makes a tenth
// to a sixth faster (docs/compile_time.md).
enum class Code { scalar, lanes };

// `wish`, else $KANEC_CXX: that one and no other. Else the first there is of $CXX, clang++, c++, g++, for lanes of
// $CXX, g++, c++, clang++. Each may carry arguments after blanks. Throws BuildError that names all that were tried, or
// shows what a broken one says.
Compiler find_compiler(const std::string& wish, Code code = Code::scalar);

// The same in two steps: found, its version not yet asked for; and asked, which starts it. Throw BuildError.
Compiler locate_compiler(const std::string& wish, Code code = Code::scalar);
std::string version_of(const Compiler& compiler);

// $KANEC_CXXFLAGS split on blanks, or -O2 -march=native -fno-math-errno -fno-tree-slp-vectorize.
std::vector<std::string> default_flags();

// The whole command for one shared library: what every model needs (C++17, position independent, nothing exported but
// the entry), then `flags`, which may overrule it, then the files.
std::vector<std::string> command_line(const Compiler& compiler, const std::vector<std::string>& flags,
                                      const std::filesystem::path& main, const std::filesystem::path& library);

// Runs it, with its temporary files in the folder `temporary`; the wall time [s]. Throws BuildError with command and
// output when it fails or makes no library.
double make_library(const std::vector<std::string>& command, const std::filesystem::path& library,
                    const std::filesystem::path& temporary);

}  // namespace kanec::compile
