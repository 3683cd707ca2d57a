// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/median.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/tangent.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// In one state: largest errors of a component, and the largest component.
struct Errors {
  double precise = 0.0, generic = 0.0, generic_double = 0.0;
  double size = 0.0;
};

template <class Real>
bool all_finite(const std::vector<Real>& values) {
  return std::all_of(values.begin(), values.end(), [](Real value) { return std::isfinite(value); });
}

template <class Real>
double difference(const std::vector<Real>& found, const std::vector<Real>& expected) {
  if (found.size() != expected.size()) throw InternalError("results of different lengths");
  Real error = 0;
  for (std::size_t i = 0; i < found.size(); ++i) error = std::max(error, std::fabs(found[i] - expected[i]));
  return static_cast<double>(error);
}

// The generic result, as far as it is comparable, or nothing where A is singular or a number is not finite.
template <class Real>
std::optional<std::vector<Real>> expected(const scene::Scene& scene, const std::vector<std::string>& parts,
                                          const State& state) {
  try {
    const std::vector<Real> values = generic_path<Real>(scene, parts, state);
    if (all_finite(values)) return comparable(scene, parts, state.x, values);
  } catch (const InputError&) {
  }
  return std::nullopt;
}

// Nothing where the result is undefined.
std::optional<Errors> errors(const scene::Scene& scene, const CompiledModel& model, const std::string& function,
                             const State& state) {
  const std::vector<std::string> parts = parts_of_emitted(function, model.requests);
  const auto generic = expected<long double>(scene, parts, state);
  if (!generic) return std::nullopt;
  const std::vector<double> found = emitted(model.library.abi(), scene, function, state);
  if (!all_finite(found)) return Errors{infinity, infinity, infinity, 0.0};
  const std::vector<Precise> exact = precise(model.generated().program, function, state);
  const auto in_double = expected<double>(scene, parts, state);
  const auto wide = [](const std::vector<double>& values) {
    return std::vector<long double>(values.begin(), values.end());
  };
  return Errors{difference(found, exact), difference(comparable(scene, parts, state.x, wide(found)), *generic),
                in_double ? difference(wide(*in_double), *generic) : infinity, largest(exact)};
}

// 0 / 0 counts as 0.
double quotient(double error, double size) { return error == 0.0 ? 0.0 : error / size; }
// The median over the states in which the result is not zero throughout.
double usual_size(const std::vector<Errors>& by_state) {
  std::vector<double> sizes;
  for (const Errors& error : by_state)
    if (error.size > 0.0) sizes.push_back(error.size);
  return sizes.empty() ? 0.0 : median(std::move(sizes));
}

// What errors are measured by. A result that is zero but for roundings, as the generic path in double shows, is
// measured by what was rounded.
double judged_size(const Errors& error, double usual) {
  constexpr double digits = 0x1p52;
  const double size = std::max(error.size, usual);
  const bool is_noise = std::isfinite(error.generic_double) && size < 1e3 * error.generic_double;
  return is_noise ? error.generic_double * digits : size;
}

// Of the states with these numbers, which have a result.
Agreement summary(const std::string& function, const std::vector<Errors>& errors, const std::vector<int>& states) {
  Agreement agreement{function};
  if (errors.empty()) return agreement;
  const double usual = usual_size(errors);
  std::vector<double> ulps;
  for (const Errors& error : errors) {
    const double size = judged_size(error, usual);
    ulps.push_back(in_ulps(error.precise, size));
    agreement.generic = std::max(agreement.generic, quotient(error.generic, size));
    agreement.generic_double = std::max(agreement.generic_double, quotient(error.generic_double, size));
  }
  const auto worst = std::max_element(ulps.begin(), ulps.end());
  agreement.worst_state = states[static_cast<std::size_t>(worst - ulps.begin())];
  agreement.largest_ulps = *worst;
  agreement.median_ulps = median(ulps);
  return agreement;
}

// All states of one function; `done` after each.
Agreement agreement(const scene::Scene& scene, const CompiledModel& model, const std::string& function,
                    const std::vector<State>& states, const std::function<void()>& done) {
  std::vector<Errors> list;
  std::vector<int> defined;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (const auto error = errors(scene, model, function, states[i])) {
      list.push_back(*error);
      defined.push_back(static_cast<int>(i));
    }
    done();
  }
  Agreement result = summary(function, list, defined);
  result.states = static_cast<int>(states.size());
  result.undefined = result.states - static_cast<int>(defined.size());
  return result;
}

}  // namespace

std::vector<Agreement> agreements(const scene::Scene& scene, const CompiledModel& model,
                                  const std::vector<State>& states, const std::function<void(double)>& progress) {
  const std::vector<program::Function>& functions = model.generated().program.functions;
  const auto total = static_cast<double>(functions.size() * states.size());
  std::vector<Agreement> list;
  double count = 0.0;
  for (const program::Function& function : functions)
    list.push_back(agreement(scene, model, function.name, states, [&] { progress(++count / total); }));
  return list;
}

}  // namespace kanec
