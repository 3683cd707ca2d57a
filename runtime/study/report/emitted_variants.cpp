// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/emitted_variants.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "runtime/bench/batch_run.hpp"
#include "runtime/bench/variants.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/study/report/float_error.hpp"
#include "runtime/study/report/generic_result.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec {
namespace {

constexpr double min_time = 0.1;  // of each variant of a function [s]

// Results of one variant in all states.
class Results {
 public:
  virtual ~Results() = default;
  // `request`: "a+b"
  virtual std::vector<double> of(const std::string& request, std::size_t state) = 0;
};

class Single : public Results {
 public:
  Single(const scene::Scene& scene, CompiledModel model, const std::vector<State>& states)
      : scene_(scene), model_(std::move(model)), states_(states) {}

  std::vector<double> of(const std::string& request, std::size_t state) override {
    return emitted(model_.library.abi(), scene_, emitted_name(request), states_[state]);
  }

 private:
  const scene::Scene& scene_;
  CompiledModel model_;
  const std::vector<State>& states_;
};

class InLanes : public Results {
 public:
  InLanes(CompiledModel model, const std::vector<State>& states)
      : model_(std::move(model)), batch_(batch_run(model_.library.batch(), in_blocks(states))) {}

  std::vector<double> of(const std::string& request, std::size_t state) override {
    const int call = batch_->find(emitted_name(request));
    if (request != evaluated_) batch_->evaluate(call);
    evaluated_ = request;
    const std::vector<long double> result = batch_->result(call, state);
    return {result.begin(), result.end()};
  }

 private:
  // A pool has whole blocks of lanes, of which one has at most these many.
  static std::vector<State> in_blocks(std::vector<State> states) {
    constexpr std::size_t most_lanes = 64;
    const State filling = states.front();
    states.resize((states.size() + most_lanes - 1) / most_lanes * most_lanes, filling);
    return states;
  }

  CompiledModel model_;
  std::unique_ptr<BatchRun> batch_;
  std::string evaluated_;
};

class GenericPath : public Results {
 public:
  GenericPath(const scene::Scene& scene, const std::vector<State>& states) : scene_(scene), states_(states) {}

  std::vector<double> of(const std::string& request, std::size_t state) override {
    return generic_path<double>(scene_, parts_of(request), states_[state]);
  }

 private:
  const scene::Scene& scene_;
  const std::vector<State>& states_;
};

class Variants {
 public:
  Variants(const scene::Scene& scene, const VariantOptions& options)
      : scene_(scene),
        options_(options),
        list_(variants({"composite", "articulated", "size", "lanes", "float_lanes"}, options.build)) {
    for (const auto* states : {&options.random, &options.hard})
      for (const State& state : *states) {
        doubles_.push_back(with_defaults(state));
        floats_.push_back(in_float(doubles_.back()));
      }
  }

  std::vector<VariantErrors> all() {
    const Contest contest = contests({scene_}, {options_.functions, list_, {}, min_time}).front();
    std::vector<VariantErrors> found;
    for (const std::string& request : options_.functions) {
      const std::string function = emitted_name(request);
      const Exact exact_doubles = exact(request, doubles_), exact_floats = exact(request, floats_);
      for (const Entry& entry : contest.entries) {
        if (entry.function != function || !entry.time || is_the_same(entry)) continue;
        const bool is_float = entry.name == "float_lanes";
        const UlpErrors ulps = errors(request, entry.name, is_float ? exact_floats : exact_doubles,
                                      is_float ? digits_of_float : digits_of_double);
        found.push_back({function, entry.name, is_float, ulps, entry.time->median});
      }
    }
    return found;
  }

 private:
  using Exact = std::vector<std::optional<std::vector<Precise>>>;

  State with_defaults(State state) const {
    state.parameters = default_parameters(scene_);
    state.inputs = default_inputs(scene_);
    return state;
  }

  // The choice of an algorithm concerns accelerations alone.
  static bool is_the_same(const Entry& entry) {
    return entry.function != "accelerations" && (entry.name == "composite" || entry.name == "articulated");
  }

  Exact exact(const std::string& request, const std::vector<State>& states) const {
    Exact list;
    for (const State& state : states) list.push_back(generic_result<Precise>(scene_, parts_of(request), state));
    return list;
  }

  std::unique_ptr<Results> results_of(const std::string& name) const {
    const auto same = std::find_if(list_.begin(), list_.end(), [&](const Variant& v) { return v.name == name; });
    if (same == list_.end()) return std::make_unique<GenericPath>(scene_, doubles_);
    if (!same->lanes) return std::make_unique<Single>(scene_, build(scene_, options_.functions, same->build), doubles_);
    const bool is_float = same->lanes->scalar == "float";
    return std::make_unique<InLanes>(build_batch(scene_, options_.functions, same->build, *same->lanes),
                                     is_float ? floats_ : doubles_);
  }

  UlpErrors errors(const std::string& request, const std::string& variant, const Exact& exact, int digits) {
    std::unique_ptr<Results>& results = results_[variant];
    if (!results) results = results_of(variant);
    StateErrors list(options_.random.size());
    for (std::size_t i = 0; i < exact.size(); ++i)
      list.add(exact[i] ? std::optional(error(results->of(request, i), request, i, *exact[i])) : std::nullopt);
    return list.summary(digits);
  }

  StateError error(const std::vector<double>& found, const std::string& request, std::size_t state,
                   const std::vector<Precise>& exact) const {
    return {difference(comparable(scene_, parts_of(request), doubles_[state].x, found), exact), largest(exact)};
  }

  const scene::Scene& scene_;
  const VariantOptions& options_;
  std::vector<Variant> list_;
  std::vector<State> doubles_, floats_;  // the random ones first
  std::map<std::string, std::unique_ptr<Results>> results_;
};

}  // namespace

std::vector<VariantErrors> variant_errors(const scene::Scene& scene, const VariantOptions& options) {
  return Variants(scene, options).all();
}

}  // namespace kanec
