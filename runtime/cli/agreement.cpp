// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/cli/paths.hpp"

namespace kanec::cli {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// In one state: largest errors of a component, and the largest component.
struct Errors {
  double precise = 0.0, generic = 0.0, generic_double = 0.0;
  double size = 0.0;
};

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double ulp_of(double value) { return std::ldexp(1.0, std::max(std::ilogb(value), -1022) - 52); }

double largest(const std::vector<Precise>& values) {
  double size = 0.0;
  for (const Precise& value : values) size = std::max(size, value.magnitude().rounded());
  return size;
}

double difference(const std::vector<double>& found, const std::vector<Precise>& exact) {
  double error = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    error = std::max(error, (Precise(found[i]) - exact[i]).magnitude().rounded());
  return error;
}

template <class Real>
double difference(const std::vector<double>& found, const std::vector<Real>& expected) {
  Real error = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!std::isfinite(expected[i])) return infinity;
    error = std::max(error, std::fabs(static_cast<Real>(found[i]) - expected[i]));
  }
  return static_cast<double>(error);
}

Errors errors(const scene::Scene& scene, const CompiledModel& model, const std::string& function, const State& state) {
  const std::vector<double> found = emitted(model.library.abi(), function, state);
  if (!all_finite(found)) return {infinity, infinity, infinity, 0.0};
  const std::vector<Precise> exact = precise(model.generated.program, function, state);
  return {difference(found, exact), difference(found, generic_path<long double>(scene, function, state)),
          difference(found, generic_path<double>(scene, function, state)), largest(exact)};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// 0 / 0 counts as 0.
double quotient(double error, double size) { return error == 0.0 ? 0.0 : error / size; }
double in_ulps(double error, double size) { return error == 0.0 ? 0.0 : size == 0.0 ? infinity : error / ulp_of(size); }

// The median over the states in which the result is not zero throughout.
double usual_size(const std::vector<Errors>& by_state) {
  std::vector<double> sizes;
  for (const Errors& error : by_state)
    if (error.size > 0.0) sizes.push_back(error.size);
  return sizes.empty() ? 0.0 : median(std::move(sizes));
}

Agreement summary(const std::string& function, const std::vector<Errors>& by_state) {
  const double usual = usual_size(by_state);
  std::vector<double> ulps;
  Agreement agreement{function};
  for (const Errors& error : by_state) {
    const double size = std::max(error.size, usual);
    ulps.push_back(in_ulps(error.precise, size));
    agreement.generic = std::max(agreement.generic, quotient(error.generic, size));
    agreement.generic_double = std::max(agreement.generic_double, quotient(error.generic_double, size));
  }
  const auto worst = std::max_element(ulps.begin(), ulps.end());
  agreement.worst_state = static_cast<int>(worst - ulps.begin());
  agreement.largest_ulps = *worst;
  agreement.median_ulps = median(ulps);
  return agreement;
}

}  // namespace

std::vector<Agreement> agreements(const scene::Scene& scene, const CompiledModel& model,
                                  const std::vector<State>& states, const std::function<void(double)>& progress) {
  std::vector<Agreement> list;
  const std::vector<program::Function>& functions = model.generated.program.functions;
  const auto total = static_cast<double>(functions.size() * states.size());
  for (const program::Function& function : functions) {
    std::vector<Errors> by_state;
    for (const State& state : states) {
      by_state.push_back(errors(scene, model, function.name, state));
      progress(static_cast<double>(list.size() * states.size() + by_state.size()) / total);
    }
    list.push_back(summary(function.name, by_state));
  }
  return list;
}

}  // namespace kanec::cli
