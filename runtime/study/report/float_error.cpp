// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/float_error.hpp"

#include "generator/program/evaluate.hpp"
#include "runtime/base/error.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec {
namespace {

std::vector<float> narrowed(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

State in_float(State state) {
  for (auto* values : {&state.parameters, &state.x, &state.y, &state.ydot, &state.inputs})
    for (double& value : *values) value = static_cast<double>(static_cast<float>(value));
  state.t = static_cast<double>(static_cast<float>(state.t));
  return state;
}

StateError error_in_float(const program::Program& program, const program::Function& function, const State& state) {
  const State rounded = in_float(state);
  const program::Arguments<float> at{narrowed(rounded.parameters), narrowed(rounded.x),
                                     narrowed(rounded.y),          narrowed(rounded.ydot),
                                     narrowed(rounded.inputs),     static_cast<float>(rounded.t)};
  const std::vector<float> found = program::evaluate(program, function, at);
  try {
    const std::vector<Precise> exact = precise(program, function.name, rounded);
    return {difference({found.begin(), found.end()}, exact), largest(exact)};
  } catch (const InputError&) {
    return {};  // of numbers that float does not have
  }
}

}  // namespace kanec
