// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/comparison.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "generator/choice/requests.hpp"
#include "generator/choice/rounding.hpp"
#include "generator/program/passes.hpp"
#include "generator/scene/states.hpp"
#include "runtime/base/median.hpp"

namespace kanec {
namespace {

using symbolic::Reductions;
using symbolic::Way;

// A way that loses digits is not kept: one may err so many times as much as the best, and by so many ulps anyway. The
// best of those, that is, which cost less than so many times the cheapest.
constexpr double most_error = 1.5, any_error = 4.0, most_cost = 1.5;
constexpr std::size_t most_outputs = 24;  // of which errors are looked at
constexpr double unknown = std::numeric_limits<double>::infinity();

// Arguments in which ways are compared: random, but for parameters, which are the scene's.
std::vector<program::Arguments<double>> typical_arguments(const scene::Scene& scene) {
  constexpr int n_states = 15;
  Random random(1);
  std::vector<program::Arguments<double>> list;
  for (int i = 0; i < n_states; ++i) {
    const RandomState at = random_state(scene, random);
    const std::vector<double> inputs = random_inputs(scene, random);
    list.push_back({scene::default_parameters(scene), at.x, at.y, at.ydot, inputs, at.t});
  }
  return list;
}

}  // namespace

Comparison::Comparison(const scene::Scene& scene, const Reductions& base, std::vector<std::string> names)
    : scene_(scene), base_(base), names_(std::move(names)), candidates_(names_.size()) {
  if (names_ == std::vector<std::string>{"accelerations"}) states_ = typical_arguments(scene);
}

void Comparison::add(const Way& way) {
  if (names_.empty()) return;
  const program::Program program = program::optimized(program_of(scene_, names_, way));
  const std::vector<program::Ledger> costs = program::ledgers(program);
  for (std::size_t i = 0; i < costs.size(); ++i)
    candidates_[i].push_back({way, costs[i], error(program, i, weighted_cost(costs[i]))});
}

void Comparison::add_mended() {
  if (base_.group <= few_links) return;
  std::vector<Way> ways;
  for (const std::string& name : names_) {
    const long cost = weighted_cost(best(name).cost);
    for (const Candidate& candidate : candidates(name)) {
      if (weighted_cost(candidate.cost) >= cost || !(candidate.way.reductions == base_)) continue;
      Way way = candidate.way;
      way.reductions.group = few_links;
      if (!is_known(way)) ways.push_back(way);
    }
  }
  for (const Way& way : ways) add(way);
}

const Candidate* Comparison::best(const std::string& name, const Filter& filter) const {
  std::vector<const Candidate*> list;
  for (const Candidate& candidate : candidates(name))
    if (filter(candidate.way)) list.push_back(&candidate);
  double least = unknown;
  for (const Candidate* candidate : list) least = std::min(least, candidate->error);
  const Candidate* best = nullptr;
  for (const Candidate* candidate : list) {
    const bool loses = candidate->error > std::max(any_error, most_error * least);
    if (!loses && (!best || weighted_cost(candidate->cost) < weighted_cost(best->cost))) best = candidate;
  }
  return best;
}

const Candidate& Comparison::best(const std::string& name) const {
  const auto is_whole = [this](Way way) {
    way.reductions.group = base_.group;
    return way.reductions == base_;
  };
  const Way first = best(name, is_whole)->way;
  return *best(name, [&first](const Way& way) { return way.algorithm == first.algorithm && way.axes == first.axes; });
}

std::vector<Way> Comparison::best_ways() const {
  std::vector<Way> ways;
  for (const std::string& name : names_)
    if (std::find(ways.begin(), ways.end(), best(name).way) == ways.end()) ways.push_back(best(name).way);
  return ways;
}

const std::vector<Candidate>& Comparison::candidates(const std::string& name) const {
  return candidates_[static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin())];
}

double Comparison::error(const program::Program& program, std::size_t number, long cost) const {
  if (states_.empty()) return 0.0;
  for (const Candidate& other : candidates_[number])
    if (static_cast<double>(cost) > most_cost * static_cast<double>(weighted_cost(other.cost))) return unknown;
  std::vector<double> errors;
  for (const program::Arguments<double>& at : states_)
    errors.push_back(expected_rounding(program, program.functions[number], at, most_outputs).ulps());
  return median(std::move(errors));
}

bool Comparison::is_known(const Way& way) const {
  return std::any_of(candidates_[0].begin(), candidates_[0].end(), [&](const auto& one) { return one.way == way; });
}

}  // namespace kanec
