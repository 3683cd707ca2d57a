// The built kanec run as a process, in a folder of its own. Not: any expectation but that nothing is left behind.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"

namespace kanec::cli::test {

namespace fs = std::filesystem;
using kanec::test::Folder;
using kanec::test::names;
using kanec::test::Variable;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Answer {
  int status;
  std::string out, err;
};

inline std::string model(const std::string& name) { return KANEC_SOURCE_DIR "/models/" + name; }

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

class Program : public testing::Test {
 protected:
  Program() { fs::create_directory(work()); }

  // Runs kanec in work(). `redirection` as a shell has it: ">/dev/full".
  Answer kanec(const std::vector<std::string>& arguments, const std::string& input = {},
               const std::string& redirection = {}) const {
    const fs::path errors = folder_.path() / "errors";
    std::vector<std::string> command = {"/bin/sh",
                                        "-c",
                                        "cd \"$0\" && errors=$1 && shift && exec \"$@\" 2>\"$errors\" " + redirection,
                                        work().string(),
                                        errors.string(),
                                        KANEC_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run_process(command, input);
    return {result.status, result.output, read_file(errors)};
  }

  // Refused with exit status 2, one message, nothing on standard output, and no file but `files` in work().
  void refuses(const std::vector<std::string>& arguments, const std::string& message,
               const std::vector<std::string>& files = {}, const std::string& input = {}) const {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Answer answer = kanec(arguments, input);
    EXPECT_EQ(answer.status, 2) << answer.err;
    EXPECT_THAT(answer.err, testing::StartsWith("kanec: "));
    EXPECT_THAT(answer.err, HasSubstr(message));
    EXPECT_THAT(answer.out, IsEmpty());
    EXPECT_EQ(names(work()), files);
  }

  // Its standard output, read; the run must succeed.
  json json_of(const std::vector<std::string>& arguments, const std::string& input = {}) const {
    const Answer answer = kanec(arguments, input);
    EXPECT_EQ(answer.status, 0) << answer.err;
    return json::parse(answer.out);
  }

  fs::path work() const { return folder_.path() / "work"; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(work() / name) << text;
    return name;
  }

 private:
  Folder folder_;
  // one cache for all tests of this build: each model is compiled once, without optimisation, which is quick
  Variable cache_{"KANEC_CACHE", std::string(KANEC_BINARY_DIR) + "/tests/cli_cache"};
  Variable flags_{"KANEC_CXXFLAGS", "-O0"};
  Variable kanec_cxx_{"KANEC_CXX", std::nullopt};
  Variable cxx_{"CXX", std::nullopt};
};

}  // namespace kanec::cli::test
