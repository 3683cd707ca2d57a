// From a scene to a compiled and loaded model, told in a line on standard error. Not: any of the steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/compile/compile.hpp"

namespace kanec::cli {

struct BuildArguments {
  std::optional<symbolic::Algorithm> algorithm;  // none: the cheapest
  emit::Optimize optimize = emit::Optimize::speed;
  std::string compiler;
  std::string flags;
  bool flags_given = false;
  bool no_cache = false;
  std::string cache;
};

void add_build(CLI::App& command, BuildArguments& arguments);
// " --optimize size --flags -O3": those that change what is compiled, as they are typed.
std::string build_text(const BuildArguments& arguments);
compile::Options compile_options(const BuildArguments& arguments);

struct CompiledModel {
  Generated generated;
  compile::Model library;
  std::vector<std::string> requests;  // its functions, as they were asked for
};

// What the scene asks for, or the usual functions, where `functions` is empty; with Taylor series where they have all
// rates in one. Throws InputError, BuildError, LoadError, Interrupted.
CompiledModel build(const scene::Scene& scene, const std::vector<std::string>& functions,
                    const BuildArguments& arguments, bool with_taylor = false);

// The same for lanes (runtime/abi/batch_solver.hpp), a library of its own: its `library.batch()` is for BatchSolver.
// scalar: "double" or "float"; lanes: 0 for as many as the processor computes with at once.
struct LaneArguments {
  std::string scalar = "double";
  int lanes = 0;
};
CompiledModel build_batch(const scene::Scene& scene, const std::vector<std::string>& functions,
                          const BuildArguments& arguments, const LaneArguments& lanes = {});

// --algorithm of accelerations.
void add_algorithm(CLI::App& command, std::optional<symbolic::Algorithm>& algorithm);
// --optimize: loops over bodies or straight lines.
void add_optimize(CLI::App& command, emit::Optimize& optimize);
// --functions a,b+c
void add_functions(CLI::App& command, std::vector<std::string>& functions);

}  // namespace kanec::cli
