// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/paths.hpp"

#include <algorithm>

#include "generator/program/evaluate.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/verify/precise_scalar.hpp"

namespace kanec {
namespace {

template <class Real>
std::vector<Real> as(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

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

}  // namespace kanec
