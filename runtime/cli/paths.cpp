// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/paths.hpp"

#include "generator/program/evaluate.hpp"
#include "runtime/base/error.hpp"
#include "runtime/generic/evaluate.hpp"

namespace kanec::cli {
namespace {

template <class Real>
std::vector<Real> as(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

const program::Function& find(const program::Program& program, const std::string& name) {
  for (const program::Function& function : program.functions)
    if (function.name == name) return function;
  throw InternalError("no function " + name + " in the program");
}

}  // namespace

std::vector<double> emitted(const kanec_model& model, const std::string& function, const State& state) {
  Solver solver(model);
  solver.set_parameters(state.parameters);
  solver.set_inputs(state.inputs);
  const kanec_function* entry = solver.find(function);
  if (!entry) throw InternalError("no function " + function + " in the compiled model");
  std::vector<double> out(static_cast<std::size_t>(entry->n_out));
  solver.evaluate(*entry, 0.0, state.x.data(), state.y.data(), state.ydot.data(), out.data());
  return out;
}

template <class Real>
std::vector<Real> generic_path(const scene::Scene& scene, const std::string& function, const State& state) {
  const generic::System<Real> system(scene, state.parameters);
  const auto x = as<Real>(state.x), y = as<Real>(state.y), ydot = as<Real>(state.ydot), u = as<Real>(state.inputs);
  return generic::evaluate<Real>(system, function, {Real(0), x, y, ydot, u});
}

template std::vector<double> generic_path(const scene::Scene&, const std::string&, const State&);
template std::vector<long double> generic_path(const scene::Scene&, const std::string&, const State&);

std::vector<Precise> precise(const program::Program& program, const std::string& function, const State& state) {
  const program::Arguments<Precise> arguments{as<Precise>(state.parameters), as<Precise>(state.x), as<Precise>(state.y),
                                              as<Precise>(state.ydot), as<Precise>(state.inputs)};
  return program::evaluate(program, find(program, function), arguments);
}

}  // namespace kanec::cli
