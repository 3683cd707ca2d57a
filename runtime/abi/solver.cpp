// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/abi/solver.hpp"

#include "runtime/base/error.hpp"

namespace kanec {
namespace {

std::span<const double> list(const double* values, int count) { return {values, static_cast<std::size_t>(count)}; }

}  // namespace

Solver::Solver(const kanec_model& model)
    : model_(&model), prepared_(model.prepared_size / sizeof(double) + 1) {
  set_parameters(list(model.parameter_defaults, model.n_parameters));
  set_inputs(list(model.input_defaults, model.n_inputs));
}

void Solver::set_parameters(std::span<const double> parameters) {
  if (parameters.size() != static_cast<std::size_t>(model_->n_parameters)) throw InputError("wrong number of parameters");
  parameters_.assign(parameters.begin(), parameters.end());
  model_->prepare(parameters_.data(), prepared_.data());
}

void Solver::set_inputs(std::span<const double> inputs) {
  if (inputs.size() != static_cast<std::size_t>(model_->n_inputs)) throw InputError("wrong number of inputs");
  inputs_.assign(inputs.begin(), inputs.end());
}

const kanec_function* Solver::find(std::string_view name) const {
  for (const kanec_function& function : std::span(model_->functions, static_cast<std::size_t>(model_->n_functions)))
    if (name == function.name) return &function;
  return nullptr;
}

const kanec_pattern* Solver::find_pattern(std::string_view name) const {
  for (const kanec_pattern& pattern : std::span(model_->patterns, static_cast<std::size_t>(model_->n_patterns)))
    if (name == pattern.name) return &pattern;
  return nullptr;
}

}  // namespace kanec
