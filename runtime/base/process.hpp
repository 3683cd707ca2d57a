// Another program, started without a shell. Not here: which compiler or plotter is wanted.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanec {

struct ProcessResult {
  int status = 0;      // exit status; 128 + signal number when killed
  std::string output;  // standard output and standard error, in the order they came
};

// The executable that `name` means: itself when it holds a slash, else the first on PATH. Empty when there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

// Name and value, beside the environment of our own or in place of what stands there.
using Environment = std::vector<std::pair<std::string, std::string>>;

// Runs argv[0] with the arguments and `input` as its standard input, until it ends and its output is closed. No shell
// sees any of it. Throws FileError when it cannot be started.
ProcessResult run_process(const std::vector<std::string>& argv, std::string_view input = {},
                          const Environment& variables = {});

}  // namespace kanec
