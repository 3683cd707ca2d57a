// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/hard/rounding.hpp"

#include <cmath>
#include <limits>

#include "generator/program/evaluate.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/median.hpp"
#include "runtime/cli/paths.hpp"
#include "runtime/cli/ulps.hpp"

namespace kanec::cli::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::string function = "accelerations";

// The largest error of a component in ulps of the largest component.
double error(const std::vector<double>& found, const std::vector<long double>& exact) {
  long double worst = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!std::isfinite(found[i])) return infinity;
    worst = std::max(worst, std::fabs(static_cast<long double>(found[i]) - exact[i]));
    size = std::max(size, std::fabs(exact[i]));
  }
  return in_ulps(static_cast<double>(worst), static_cast<double>(size));
}

std::vector<float> as_float(std::vector<double>& values) {
  const std::vector<float> list(values.begin(), values.end());
  values.assign(list.begin(), list.end());
  return list;
}

// Of the program in float at the state as float has it, relative to the largest component.
double error_in_float(const program::Program& program, State state) {
  const program::Arguments<float> at{as_float(state.parameters), as_float(state.x),      as_float(state.y),
                                     as_float(state.ydot),       as_float(state.inputs), static_cast<float>(state.t)};
  state.t = static_cast<double>(at.time);
  const std::vector<float> found = program::evaluate(program, find(program, function), at);
  try {
    const std::vector<Precise> exact = precise(program, function, state);
    const double size = largest(exact), off = difference({found.begin(), found.end()}, exact);
    return off == 0.0 ? 0.0 : off / size;
  } catch (const InputError&) {
    return infinity;  // of numbers that float does not have
  }
}

}  // namespace

Rounding rounding(const CompiledModel& model, const scene::Scene& scene, const std::vector<State>& states) {
  std::vector<double> of_emitted, of_generic, of_single;
  for (const State& state : states) {
    const std::vector<long double> exact = generic_path<long double>(scene, {function}, state);
    of_emitted.push_back(error(emitted(model.library.abi(), scene, function, state), exact));
    of_generic.push_back(error(generic_path<double>(scene, {function}, state), exact));
    of_single.push_back(error_in_float(model.generated.program, state));
  }
  return states.empty() ? Rounding{} : Rounding{median(of_emitted), median(of_generic), median(of_single)};
}

}  // namespace kanec::cli::hard
