// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/evaluate.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"

namespace kanec {
namespace {

// The values of those that the model knows, in its order.
std::vector<double> kept(const char* const* names, int count, const std::vector<scene::Named>& list,
                         const std::vector<double>& values) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    const auto same = std::find_if(list.begin(), list.end(), [&](const scene::Named& n) { return n.name == names[i]; });
    if (same == list.end()) throw InternalError(std::string("no ") + names[i] + " in the scene of the compiled model");
    result.push_back(values[static_cast<std::size_t>(same - list.begin())]);
  }
  return result;
}

}  // namespace

std::vector<double> read_parameters(const kanec_model& model, const scene::Scene& scene,
                                    const std::vector<double>& values) {
  return kept(model.parameter_names, model.n_parameters, scene.parameters, values);
}

std::vector<double> read_inputs(const kanec_model& model, const scene::Scene& scene,
                                const std::vector<double>& values) {
  return kept(model.input_names, model.n_inputs, scene.inputs, values);
}

Solver solver_of(const kanec_model& model, const scene::Scene& scene, const State& state) {
  Solver solver(model);
  solver.set_parameters(read_parameters(model, scene, state.parameters));
  solver.set_inputs(read_inputs(model, scene, state.inputs));
  return solver;
}

std::vector<double> emitted(const kanec_model& model, const scene::Scene& scene, const std::string& function,
                            const State& state) {
  const Solver solver = solver_of(model, scene, state);
  const kanec_function* entry = solver.find(function);
  if (!entry) throw InternalError("no function " + function + " in the compiled model");
  std::vector<double> out(static_cast<std::size_t>(entry->n_out));
  solver.evaluate(*entry, state.t, state.x.data(), state.y.data(), state.ydot.data(), out.data());
  return out;
}

}  // namespace kanec
