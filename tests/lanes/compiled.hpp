// A model compiled for many states at once, and states to give to it and to the solver of one. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/abi/batch_solver.hpp"
#include "runtime/abi/solver.hpp"
#include "runtime/compile/compile.hpp"
#include "tests/lower/sample.hpp"
#include "tests/support/compiled.hpp"

namespace kanec::test {

// Lanes of "double" or "float", 0 for as many as the target has.
struct LaneChoice {
  const char* scalar = "double";
  int lanes = 0;
};

compile::Model compiled_in_lanes(const Generated& generated, const scene::Scene& scene, const LaneChoice& choice);

// Samples of one scene, in the layout of BatchStates.
template <class Real>
struct SampleBatch {
  // stride 0: the number of samples
  SampleBatch(const std::vector<Sample>& samples, const kanec_model& model, std::int64_t stride);

  BatchStates<Real> states() const;
  // Entry i of state j of results with n entries a state.
  double at(const std::vector<Real>& results, int n, int i, std::int64_t j) const;
  std::size_t size(int n) const;  // of an argument with n entries

  std::int64_t count, stride;
  std::vector<Real> t, x, y, ydot, u, parameters;
};

// Parameters, inputs that the model reads, in its order.
std::vector<double> read_parameters(const Sample& sample, const kanec_model& model);
std::vector<double> read_inputs(const Sample& sample, const kanec_model& model);

// Solver's result for one sample.
std::vector<double> scalar_result(Solver& solver, const std::string& function, const Sample& sample);

}  // namespace kanec::test
