// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/hard/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/median.hpp"
#include "runtime/cli/paths.hpp"
#include "runtime/cli/ulps.hpp"

namespace kanec::cli::hard {
namespace {

// The largest error of a component in ulps of the largest component.
double error(const std::vector<double>& found, const std::vector<long double>& exact) {
  long double worst = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!std::isfinite(found[i])) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, std::fabs(static_cast<long double>(found[i]) - exact[i]));
    size = std::max(size, std::fabs(exact[i]));
  }
  return in_ulps(static_cast<double>(worst), static_cast<double>(size));
}

}  // namespace

Rounding rounding(const CompiledModel& model, const scene::Scene& scene, const std::vector<State>& states) {
  std::vector<double> emitted_errors, generic_errors;
  for (const State& state : states) {
    const std::vector<long double> exact = generic_path<long double>(scene, {"accelerations"}, state);
    emitted_errors.push_back(error(emitted(model.library.abi(), scene, "accelerations", state), exact));
    generic_errors.push_back(error(generic_path<double>(scene, {"accelerations"}, state), exact));
  }
  return states.empty() ? Rounding{} : Rounding{median(emitted_errors), median(generic_errors)};
}

}  // namespace kanec::cli::hard
