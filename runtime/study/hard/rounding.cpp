// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/rounding.hpp"

#include <cmath>
#include <limits>

#include "runtime/base/median.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/study/report/float_error.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::string function = "accelerations";

// The largest error of a component in ulps of the largest component.
double error(const std::vector<double>& found, const std::vector<long double>& exact) {
  long double worst = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!std::isfinite(found[i]) || !std::isfinite(exact[i])) return infinity;
    worst = std::max(worst, std::fabs(static_cast<long double>(found[i]) - exact[i]));
    size = std::max(size, std::fabs(exact[i]));
  }
  return in_ulps(static_cast<double>(worst), static_cast<double>(size));
}

double relative(const StateError& one) { return one.error == 0.0 ? 0.0 : one.error / one.size; }

}  // namespace

Rounding rounding(const CompiledModel& model, const scene::Scene& scene, const std::vector<State>& states) {
  const program::Program& program = model.generated().program;
  std::vector<double> of_emitted, of_generic, of_single;
  for (const State& state : states) {
    const std::vector<long double> exact = generic_path<long double>(scene, {function}, state);
    of_emitted.push_back(error(emitted(model.library.abi(), scene, function, state), exact));
    of_generic.push_back(error(generic_path<double>(scene, {function}, state), exact));
    of_single.push_back(relative(error_in_float(program, find(program, function), state)));
  }
  return states.empty() ? Rounding{} : Rounding{median(of_emitted), median(of_generic), median(of_single)};
}

}  // namespace kanec::hard
