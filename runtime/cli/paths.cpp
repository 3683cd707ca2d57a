// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/paths.hpp"

#include <algorithm>

#include "generator/program/evaluate.hpp"
#include "runtime/base/error.hpp"
#include "runtime/cli/precise_scalar.hpp"
#include "runtime/generic/evaluate.hpp"

namespace kanec::cli {
namespace {

template <class Real>
std::vector<Real> as(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

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

template <class Real>
std::vector<Real> generic_path(const scene::Scene& scene, const std::vector<std::string>& parts, const State& state) {
  const generic::System<Real> system(scene, state.parameters);
  const auto x = as<Real>(state.x), y = as<Real>(state.y), u = as<Real>(state.inputs);
  auto ydot = as<Real>(state.ydot);
  const auto evaluate = [&](const std::string& part) {
    return generic::evaluate<Real>(system, part, {Real(state.t), x, y, ydot, u});
  };
  if (std::find(parts.begin(), parts.end(), "accelerations") != parts.end()) ydot = evaluate("accelerations");
  std::vector<Real> result;
  for (const std::string& part : parts) {
    const std::vector<Real> values = evaluate(part);
    result.insert(result.end(), values.begin(), values.end());
  }
  return result;
}

template std::vector<double> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);
template std::vector<long double> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);

template std::vector<Precise> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);

std::vector<Precise> precise(const program::Program& program, const std::string& function, const State& state) {
  const program::Arguments<Precise> arguments{as<Precise>(state.parameters), as<Precise>(state.x),
                                              as<Precise>(state.y),          as<Precise>(state.ydot),
                                              as<Precise>(state.inputs),     Precise(state.t)};
  return program::evaluate(program, find(program, function), arguments);
}

}  // namespace kanec::cli
