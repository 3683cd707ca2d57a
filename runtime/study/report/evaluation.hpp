// The rounding errors of a scene's functions, computed in several ways, in double and in float. Not: how they are shown
// (evaluation_text.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "generator/program/ledger.hpp"
#include "generator/scene/scene.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/study/report/emitted_variants.hpp"
#include "runtime/study/report/ulp_errors.hpp"

namespace kanec {

// One way of computing a function.
struct WayErrors {
  std::string name;         // "kept", "masses not regrouped"
  std::string description;  // of the kept one: all that it is
  program::Ledger cost;
  UlpErrors in_double, in_float;  // from the same program in 50 digits
  UlpErrors from_generic;         // in double from the generic path in 50 digits
  double expected = 0.0;          // median over random states of what rounding.hpp expects in double
};

struct FunctionErrors {
  std::string function;
  UlpErrors generic;            // of the generic path in double, from that in 50 digits
  std::vector<WayErrors> ways;  // the kept one first
};

struct SceneErrors {
  std::string model;
  int bodies = 0, speeds = 0;
  double condition = 0.0, worst_condition = 0.0;  // of A with unit diagonal: median and largest over random states
  std::vector<FunctionErrors> functions;
  std::vector<VariantErrors> variants;  // where they are timed
  std::string failure = {};             // why there is none of this; empty: there is
};

struct EvaluationOptions {
  std::vector<std::string> functions;  // empty: those that decide on a simulation
  int states = 32;
  std::uint64_t seed = 1;
  bool is_timed = false;  // variants are compiled and timed
  BuildOptions build;
};

// States in which angles are large, axes stand along each other, or speeds are high, made of the random ones.
std::vector<State> hard_states(const scene::Scene& scene, const std::vector<State>& random);

// Those asked for, or the ones that decide on a simulation.
std::vector<std::string> evaluated_functions(const scene::Scene& scene, const EvaluationOptions& options);

// `progress` is told the share that is done.
SceneErrors evaluation_errors(const scene::Scene& scene, const EvaluationOptions& options,
                              const std::function<void(double)>& progress);

}  // namespace kanec
