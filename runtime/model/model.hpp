// From a scene to a compiled and loaded model. Not: any of the steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/compile/compile.hpp"

namespace kanec {

struct BuildOptions {
  std::optional<symbolic::Algorithm> algorithm;  // none: the cheapest
  emit::Optimize optimize = emit::Optimize::speed;
  std::string compiler;
  std::string flags;
  bool flags_given = false;
  bool no_cache = false;
  std::string cache;
  std::function<void(const std::string& text)> tell = {};  // gets a line on what becomes of the model, and notes
  // Called where building begins; what it returns is called now and then until the end, and may throw to end it.
  std::function<std::function<void()>()> watch = {};
};

// "speed", "size", "line", "loops".
const std::map<std::string, emit::Optimize>& optimize_goals();

// " --optimize size --flags -O3": those that change what is compiled, as they are typed.
std::string build_text(const BuildOptions& options);
compile::Options compile_options(const BuildOptions& options);

class CompiledModel {
 public:
  CompiledModel(compile::Model library, std::function<Generated()> generate, std::optional<Generated> generated,
                std::vector<std::string> requests);

  // What it was compiled of: derived where it is asked for, if the library came from the cache.
  const Generated& generated() const;
  std::string hash() const { return library.abi().hash; }

  compile::Model library;
  std::vector<std::string> requests;  // its functions, as they were asked for

 private:
  std::function<Generated()> generate_;
  mutable std::optional<Generated> generated_;
};

// What the scene asks for, or the usual functions, where `functions` is empty; with Taylor series where they have all
// rates in one. Throws InputError, BuildError, LoadError, Interrupted.
CompiledModel build(const scene::Scene& scene, const std::vector<std::string>& functions, const BuildOptions& options,
                    bool with_taylor = false);

// The same for lanes (runtime/abi/batch_solver.hpp), a library of its own: its `library.batch()` is for BatchSolver.
// scalar: "double" or "float"; lanes: 0 for as many as the processor computes with at once.
struct LaneArguments {
  std::string scalar = "double";
  int lanes = 0;
};
CompiledModel build_batch(const scene::Scene& scene, const std::vector<std::string>& functions,
                          const BuildOptions& options, const LaneArguments& lanes = {});

}  // namespace kanec
