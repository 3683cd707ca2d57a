// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/evaluation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "generator/choice/candidates.hpp"
#include "generator/choice/rounding.hpp"
#include "generator/program/evaluate.hpp"
#include "runtime/base/median.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/study/report/float_error.hpp"
#include "runtime/study/report/generic_result.hpp"
#include "runtime/study/report/ulp_errors.hpp"
#include "runtime/study/report/ways.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/samples.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

program::Arguments<double> arguments(const State& state) {
  return {state.parameters, state.x, state.y, state.ydot, state.inputs, state.t};
}

// Of results in 50 digits.
double distance(const std::vector<Precise>& a, const std::vector<Precise>& b) {
  double error = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) error = std::max(error, (a[i] - b[i]).magnitude().rounded());
  return error;
}

// A state with what the generic path has there; nothing where it has no result.
struct Place {
  State state;
  std::optional<std::vector<Precise>> generic;
};

class Measuring {
 public:
  Measuring(const scene::Scene& scene, const EvaluationOptions& options, const std::function<void(double)>& progress)
      : scene_(scene), options_(options), progress_(progress), random_(samples(scene, options.states, options.seed)) {
    states_ = random_;
    for (State& state : hard_states(scene, random_)) states_.push_back(std::move(state));
    const std::vector<std::string> names = evaluated_functions(scene, options);
    const std::vector<Chosen> chosen = choose_ways(scene, names);
    for (std::size_t i = 0; i < names.size(); ++i)
      work_.push_back({names[i], ways_beside(scene, names[i], chosen[i].way)});
    for (const auto& [name, ways] : work_) total_ += static_cast<double>(ways.size());
  }

  SceneErrors all() {
    SceneErrors result;
    result.model = scene_.name;
    result.bodies = size(scene_);
    result.speeds = n_speeds(scene_);
    add_condition(result);
    for (const auto& [name, ways] : work_) result.functions.push_back(of(name, ways));
    if (options_.is_timed) result.variants = variants();
    return result;
  }

 private:
  std::vector<VariantErrors> variants() const {
    VariantOptions options{{}, random_, hard_states(scene_, random_), options_.build};
    for (const auto& [name, ways] : work_) options.functions.push_back(name);
    return variant_errors(scene_, options);
  }

  // Of A with rows and columns scaled to a unit diagonal, so that units have no part in it.
  void add_condition(SceneErrors& result) const {
    std::vector<double> conditions;
    for (const State& state : random_) {
      const std::vector<double> values = generic_path<double>(scene_, {"mass_matrix"}, state);
      const auto n = static_cast<Eigen::Index>(result.speeds);
      if (n == 0) return;
      const Eigen::MatrixXd A = Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n);
      const Eigen::VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::MatrixXd scaled = scale.asDiagonal() * A * scale.asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
      const double condition = solver.eigenvalues()[n - 1] / solver.eigenvalues()[0];
      conditions.push_back(condition > 0.0 ? condition : infinity);
    }
    result.condition = median(conditions);
    result.worst_condition = *std::max_element(conditions.begin(), conditions.end());
  }

  FunctionErrors of(const std::string& name, const std::vector<NamedWay>& ways) {
    const std::vector<std::string> parts = parts_of(name);
    std::vector<Place> places;
    StateErrors generic(random_.size());
    for (const State& state : states_) {
      places.push_back({state, generic_result<Precise>(scene_, parts, state)});
      const std::optional<std::vector<Precise>>& exact = places.back().generic;
      const auto in_double = generic_result<double>(scene_, parts, state);
      const bool has_both = exact && in_double;
      generic.add(has_both ? std::optional(StateError{difference(*in_double, *exact), largest(*exact)}) : std::nullopt);
      progress_(done_ / total_);
    }
    FunctionErrors result{name, generic.summary(digits_of_double), {}};
    for (const NamedWay& way : ways) {
      WayErrors errors = of(name, parts, way, places);
      if (result.ways.empty() || !is_same(errors, result.ways.front())) result.ways.push_back(std::move(errors));
      progress_(++done_ / total_);
    }
    return result;
  }

  // A change that changes nothing.
  static bool is_same(const WayErrors& a, const WayErrors& b) {
    const auto errors = [](const WayErrors& way) {
      return std::array{way.in_double.median, way.in_double.largest, way.in_double.hard, way.expected};
    };
    return a.cost == b.cost && errors(a) == errors(b);
  }

  WayErrors of(const std::string& name, const std::vector<std::string>& parts, const NamedWay& way,
               const std::vector<Place>& places) const {
    const program::Program program = program_in(scene_, name, way);
    const program::Function& function = program.functions.front();
    StateErrors in_double(random_.size()), single(random_.size()), from_generic(random_.size());
    std::vector<double> expectations;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const State& state = places[i].state;
      if (!places[i].generic) {
        for (StateErrors* errors : {&in_double, &single, &from_generic}) errors->add(std::nullopt);
        continue;
      }
      const std::vector<double> found = program::evaluate(program, function, arguments(state));
      const std::vector<Precise> exact = precise(program, function.name, state);
      in_double.add(StateError{difference(found, exact), largest(exact)});
      from_generic.add(error_from_generic(parts, places[i], found));
      single.add(error_in_float(program, function, state));
      if (i < random_.size())
        expectations.push_back(expected_rounding(program, function, arguments(state), most_outputs).ulps());
    }
    return {way.name,
            way.name == "kept" ? description(way.way, name) : "",
            program::ledger(program, function),
            in_double.summary(digits_of_double),
            single.summary(digits_of_float),
            from_generic.summary(digits_of_double),
            expectations.empty() ? 0.0 : median(expectations)};
  }

  StateError error_from_generic(const std::vector<std::string>& parts, const Place& place,
                                const std::vector<double>& found) const {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    const double size = largest(*place.generic);
    if (!std::all_of(found.begin(), found.end(), is_finite)) return {infinity, size};
    const std::vector<Precise> wide(found.begin(), found.end());
    return {distance(comparable(scene_, parts, place.state.x, wide), *place.generic), size};
  }

  static constexpr std::size_t most_outputs = 24;  // whose expected errors are looked at

  const scene::Scene& scene_;
  const EvaluationOptions& options_;
  const std::function<void(double)>& progress_;
  std::vector<State> random_, states_;
  std::vector<std::pair<std::string, std::vector<NamedWay>>> work_;
  double total_ = 0.0, done_ = 0.0;
};

// Each angle and Euler parameter replaced by what `angle` makes of the number; all of a ball's by a turn of that about
// x.
void set_angles(const scene::Scene& scene, State& state, const std::function<double(double)>& angle) {
  const scene::Layout layout(scene);
  for (const scene::BodyLayout& at : layout.bodies) {
    for (const int theta : at.theta)
      if (theta >= 0) state.x[static_cast<std::size_t>(theta)] = angle(state.x[static_cast<std::size_t>(theta)]);
    if (at.eps < 0) continue;
    double* eps = &state.x[static_cast<std::size_t>(at.eps)];
    const double half = angle(eps[0]) / 2;
    eps[0] = std::sin(half), eps[1] = eps[2] = 0.0, eps[3] = std::cos(half);
  }
}

}  // namespace

std::vector<State> hard_states(const scene::Scene& scene, const std::vector<State>& random) {
  constexpr double high = 1e3, large = 1e4, pi = std::numbers::pi;
  const auto square = [](double angle) { return std::round(angle * 2 / pi) * pi / 2; };
  std::vector<State> list;
  // the first random one is the scene's own start
  const std::size_t first = random.size() > 1 ? 1 : 0;
  for (std::size_t i = first; i < std::min<std::size_t>(random.size(), 4); ++i) {
    State fast = random[i], aligned = random[i], right = random[i], far = random[i];
    for (double& speed : fast.y) speed *= high;
    set_angles(scene, aligned, [](double) { return 0.0; });
    set_angles(scene, right, square);
    set_angles(scene, far, [](double angle) { return large * angle; });
    list.insert(list.end(), {fast, aligned, right, far});
  }
  return list;
}

std::vector<std::string> evaluated_functions(const scene::Scene& scene, const EvaluationOptions& options) {
  if (!options.functions.empty()) return options.functions;
  std::vector<std::string> names;
  const std::vector<std::string> asked = requested_functions(scene, {});
  for (const char* name : {"accelerations", "residual", "forcing", "mass_matrix"})
    if (std::find(asked.begin(), asked.end(), name) != asked.end()) names.push_back(name);
  return names.empty() ? asked : names;
}

SceneErrors evaluation_errors(const scene::Scene& scene, const EvaluationOptions& options,
                              const std::function<void(double)>& progress) {
  return Measuring(scene, options, progress).all();
}

}  // namespace kanec
