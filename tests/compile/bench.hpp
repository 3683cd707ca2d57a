// What the tests of runtime/compile share: a small hand-written model, a compiler that counts its runs, a private
// cache. Not: any expectation but one, that nothing unfinished stays in the cache.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/abi/solver.hpp"
#include "runtime/base/files.hpp"
#include "runtime/compile/compile.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"

namespace kanec::compile::test {

inline constexpr uid_t some_other_user = 54321;

namespace fs = std::filesystem;
using kanec::test::Folder;
using kanec::test::names;
using kanec::test::Variable;

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("not in the text: " + what);
  return text.replace(at, what.size(), by);
}

// An oscillator, x' = y, y' = -k x, with the parameter k = 4.
inline Source toy() {
  const std::string header = R"(#pragma once
namespace toy {
template <class T>
void accelerations(const T& k, const T* x, T* ydot) noexcept { ydot[0] = -k * x[0]; }
}
)";
  const std::string descriptor = R"(#include "abi.h"
#include "toy.hpp"
namespace {
void prepare(const double* parameters, void* prepared) { *static_cast<double*>(prepared) = parameters[0]; }
void accelerations(const void* prepared, double, const double* x, const double*, const double*, const double*,
                   double* out) {
  toy::accelerations(*static_cast<const double*>(prepared), x, out);
}
const char* const parameter_names[] = {"k"};
const double parameter_defaults[] = {4.0};
const kanec_function functions[] = {{"accelerations", 1, 0, 1, 0, 0, 0, 0, KANEC_READS_X, accelerations}};
const char* const coordinate_names[] = {"s_1"};
const char* const speed_names[] = {"sdot_1"};
const kanec_model model = {KANEC_ABI_VERSION, sizeof(kanec_model), "toy", "0123456789abcdef", 1, 1, 1, 1, 0, 1,
                           parameter_names, parameter_defaults, nullptr, nullptr, sizeof(double), prepare, functions,
                           coordinate_names, speed_names, 0, nullptr};
}
extern "C" __attribute__((visibility("default"))) const kanec_model* kanec_model_entry(void) { return &model; }
)";
  return {"toy", "0123456789abcdef", 1, 1, {{"toy.hpp", header}, {"toy_abi.cpp", descriptor}}, "toy_abi.cpp"};
}

// The toy with another text in its descriptor file.
inline Source toy_with(const std::string& what, const std::string& by) {
  Source source = toy();
  source.files[1].second = replaced(source.files[1].second, what, by);
  return source;
}

// The same for two lanes, written as a loop: what a batch must export.
inline Source toy_batch() {
  Source source = toy();
  std::string& text = source.files[1].second;
  text = replaced(text, "&model; }",
                  "&model; }\n"
                  R"(namespace {
void prepare_batch(int64_t, int64_t, int64_t, const void* parameters, void* prepared) {
  prepare(static_cast<const double*>(parameters), prepared);
}
void evaluate_batch(const kanec_states* states, void* out) {
  for (int64_t j = states->begin; j < states->end; ++j)
    accelerations(states->prepared, 0, static_cast<const double*>(states->x) + j, nullptr, nullptr, nullptr,
                  static_cast<double*>(out) + j);
}
const kanec_evaluate_batch evaluate[] = {evaluate_batch};
const kanec_batch batch = {KANEC_ABI_VERSION, sizeof(kanec_batch), &model, 2, sizeof(double), sizeof(double),
                           alignof(double), 1, prepare_batch, evaluate, nullptr};
}
extern "C" __attribute__((visibility("default"))) const kanec_batch* kanec_model_batch(void) { return &batch; }
)");
  source.is_batch = true;
  return source;
}

// y' of the toy at x = 3: -12 by its default parameter.
inline double evaluate(const Model& model) {
  const Solver solver(model.abi());
  const double x = 3.0;
  double ydot = 0.0;
  solver.evaluate(*solver.find("accelerations"), 0.0, &x, nullptr, nullptr, &ydot);
  return ydot;
}

inline void write_script(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
  fs::permissions(path, fs::perms(0700));
}

class Bench : public testing::Test {
 protected:
  Bench() {
    std::ofstream(root() / "version") << "counting compiler 1.0\n";
    write_compiler("");
    options.compiler = compiler();
    options.flags = {"-O0"};
    options.flags_given = true;
    options.cache = cache();
  }

  void TearDown() override { EXPECT_THAT(names(cache() / "tmp"), testing::IsEmpty()) << "left in the cache"; }

  fs::path root() const { return folder_.path(); }
  fs::path cache() const { return root() / "cache"; }
  std::string compiler() const { return (root() / "counting c++").string(); }

  // Tells the version in the file "version"; otherwise notes its run, does `before`, and leaves the work to the real
  // one.
  void write_compiler(const std::string& before) const {
    const std::string at = root().string();
    write_script(compiler(), "#!/bin/sh\nfor word; do test \"$word\" = --version && exec cat '" + at +
                                 "/version'; done\necho run >> '" + at + "/runs'\n" + before + "\nexec '" +
                                 real_.path.string() + "' \"$@\"\n");
  }

  // How often something was compiled.
  int runs() const {
    std::ifstream file(root() / "runs");
    return static_cast<int>(std::count(std::istreambuf_iterator<char>(file), {}, '\n'));
  }

  // The cache's entries.
  std::vector<std::string> entries() const {
    std::vector<std::string> list = names(cache());
    std::erase(list, "tmp");
    return list;
  }

  // Where the one entry is, after a build that made it.
  fs::path make_entry() const {
    build(toy(), options);
    return cache() / entries().at(0);
  }

  Options options;

 private:
  Folder folder_;
  Variable kanec_cxx_{"KANEC_CXX", std::nullopt};
  Variable cxx_{"CXX", std::nullopt};
  Variable flags_{"KANEC_CXXFLAGS", std::nullopt};
  Compiler real_ = find_compiler("");
};

}  // namespace kanec::compile::test
