// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/candidates.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "generator/lower/derivatives.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"

namespace kanec {
namespace {

using symbolic::Algorithm;
using symbolic::Axes;
using symbolic::Reductions;
using symbolic::Way;

// A is tried up to so many blocks, or so many a link: its cost grows with them, and joint by joint is cheaper long
// before.
constexpr int most_pairs = 600;
constexpr int most_pairs_a_link = 8;
// And up to which all ways are: what they save is known by then, and deriving takes its time.
constexpr int few_pairs = 120;

struct Size {
  int links = 0;
  int pairs = 0;  // of links of which one moves the other, about the blocks of A
  bool has_balls = false;
};

Size size_of(const scene::Scene& scene, const Reductions& base) {
  const symbolic::Mechanism mechanism = symbolic::mechanism(scene, base);
  Size size{mechanism.size()};
  for (int j = 1; j <= mechanism.size(); ++j) {
    size.has_balls |= mechanism.link(j).turning == symbolic::Link::Turning::ball && mechanism.link(j).lower > 0;
    for (int k = j; k > 0; k = mechanism.link(k).lower) ++size.pairs;
  }
  return size;
}

// The function whose cost decides on the way of a requested one: accelerations where it has a part in it, else what it
// is derived from, else itself.
std::string deciding(const scene::Scene& scene, const std::string& name) {
  std::string result;
  for (const std::string& part : parts(name)) {
    std::string of = part;
    for (const lower::Derived& derived : lower::derived_functions(scene))
      if (derived.name == part) of = derived.of;
    if (result.empty() || of == "accelerations") result = of;
  }
  return result;
}

// Of all others every way is the same, but for origins, which do best where they are.
bool depends_on_way(const std::string& deciding) {
  return deciding == "residual" || deciding == "forcing" || deciding == "mass_matrix";
}

struct Candidate {
  Way way;
  program::Ledger cost;
};

// Counts ways for several functions at once.
class Comparison {
 public:
  Comparison(const scene::Scene& scene, const Reductions& base, std::vector<std::string> names)
      : scene_(scene), base_(base), names_(std::move(names)), candidates_(names_.size()) {}

  void add(const Way& way) {
    if (names_.empty()) return;
    const program::Program program = program::optimized(program_of(scene_, names_, way));
    const std::vector<program::Ledger> costs = program::ledgers(program);
    for (std::size_t i = 0; i < costs.size(); ++i) candidates_[i].push_back({way, costs[i]});
  }

  // The cheapest of those that pass the filter.
  template <class Filter>
  const Candidate* best(const std::string& name, const Filter& filter) const {
    const auto at = static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates_[at])
      if (filter(candidate.way) && (!best || weighted_cost(candidate.cost) < weighted_cost(best->cost)))
        best = &candidate;
    return best;
  }

  // Whatever others are compared, a function's way is the same: the best algorithm and axes with all that can be left
  // out, then the best of what may stay in.
  const Candidate& best(const std::string& name) const {
    const Way first = best(name, [this](const Way& way) { return way.reductions == base_; })->way;
    return *best(name, [&first](const Way& way) { return way.algorithm == first.algorithm && way.axes == first.axes; });
  }

  // Of all functions, each way once.
  std::vector<Way> best_ways() const {
    std::vector<Way> ways;
    for (const std::string& name : names_)
      if (std::find(ways.begin(), ways.end(), best(name).way) == ways.end()) ways.push_back(best(name).way);
    return ways;
  }

 private:
  const scene::Scene& scene_;
  Reductions base_;
  std::vector<std::string> names_;
  std::vector<std::vector<Candidate>> candidates_;  // by name
};

void add_all(Comparison& comparison, const std::vector<Algorithm>& algorithms, const Size& size,
             const Reductions& base) {
  for (const Algorithm algorithm : algorithms) {
    comparison.add({base, algorithm, Axes::inertial});
    if (size.has_balls) comparison.add({base, algorithm, Axes::body});
  }
  if (size.pairs > few_pairs) return;
  // where origins stay and masses are not regrouped: only in what is best otherwise
  for (Way way : comparison.best_ways())
    for (const auto& [place, regroup] : {std::pair(false, true), {true, false}, {false, false}}) {
      way.reductions.place_origins = base.place_origins && place;
      way.reductions.regroup = base.regroup && regroup;
      comparison.add(way);
    }
}

// Which algorithm is kept; nothing where there was no choice, or no difference.
std::string choice_of(const Comparison& comparison, const std::string& name) {
  const Candidate& kept = comparison.best(name);
  const Algorithm other = kept.way.algorithm == Algorithm::composite ? Algorithm::articulated : Algorithm::composite;
  const Candidate* next = comparison.best(name, [other](const Way& way) { return way.algorithm == other; });
  if (next == nullptr || next->cost == kept.cost) return "";
  return kanec::name(kept.way.algorithm) + "; " + kanec::name(other) + " would take " + program::text(next->cost);
}

bool is_derived(const scene::Scene& scene, const std::string& name) {
  const std::vector<std::string> of = parts(name);
  const std::vector<lower::Derived> derived = lower::derived_functions(scene);
  return std::any_of(derived.begin(), derived.end(),
                     [&of](const lower::Derived& d) { return std::find(of.begin(), of.end(), d.name) != of.end(); });
}

std::string words(symbolic::Derivatives derivatives) {
  return derivatives == symbolic::Derivatives::equations ? "equations differentiated" : "operations differentiated";
}

// Of the ways to make a derivative the one with the fewest operations; of what it is made of the way is known.
std::pair<Way, std::string> cheapest_derivative(const scene::Scene& scene, const std::string& name, Way way,
                                                const Size& size) {
  Comparison comparison(scene, way.reductions, {name});
  comparison.add(way);
  way.derivatives = symbolic::Derivatives::equations;
  comparison.add(way);
  const bool may_be_composite = size.pairs <= std::max(most_pairs, most_pairs_a_link * size.links);
  if (way.algorithm == Algorithm::articulated && may_be_composite) {
    way.algorithm = Algorithm::composite;
    comparison.add(way);
  }
  const Candidate* kept = comparison.best(name, [](const Way&) { return true; });
  const auto other = [kept](const Way& w) { return w.derivatives != kept->way.derivatives; };
  const Candidate* next = comparison.best(name, other);
  std::string choice;
  if (next->cost != kept->cost)
    choice =
        words(kept->way.derivatives) + "; " + words(next->way.derivatives) + " would take " + program::text(next->cost);
  return {kept->way, choice};
}

using Groups = std::vector<std::pair<Way, std::vector<std::string>>>;  // names by way

// One program of all groups, its functions in the order of `names`.
program::Program program_of_groups(const Groups& groups, const scene::Scene& scene,
                                   const std::vector<std::string>& names, const std::vector<std::string>& choices) {
  program::Program all;
  std::vector<std::string> order;
  for (const auto& [way, some] : groups) {
    program::Program part = program::optimized(program_of(scene, some, way));
    all = order.empty() ? std::move(part) : program::joined(std::move(all), part);
    order.insert(order.end(), some.begin(), some.end());
  }
  std::vector<program::Function> functions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), names[i]) - order.begin());
    functions.push_back(all.functions[at]);
    functions.back().choice = choices[i];
  }
  all.functions = std::move(functions);
  if (groups.size() == 1) return all;
  // what prepare() does is shared; the calls are left as they are, whatever others there are
  return program::drop_dead(scene.parameters.empty() ? all : program::share(all));
}

void insert(std::vector<std::string>& list, const std::string& item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

}  // namespace

std::string name(Algorithm algorithm) { return algorithm == Algorithm::composite ? "composite" : "articulated"; }

program::Program cheapest_program(const scene::Scene& scene, const std::vector<std::string>& names,
                                  std::optional<Algorithm> algorithm, const Reductions& base) {
  const Size size = size_of(scene, base);
  std::vector<std::string> solved, others;
  for (const std::string& name : names) {
    const std::string decides = deciding(scene, name);
    if (decides == "accelerations") insert(solved, decides);
    if (depends_on_way(decides)) insert(others, decides);
  }
  std::vector<Algorithm> algorithms = {Algorithm::articulated};
  if (size.pairs <= std::max(most_pairs, most_pairs_a_link * size.links)) algorithms.push_back(Algorithm::composite);
  if (algorithm) algorithms = {*algorithm};
  Comparison of_solved(scene, base, solved), of_others(scene, base, others);
  add_all(of_solved, algorithms, size, base);
  add_all(of_others, {Algorithm::composite}, size, base);

  Way plain{base};
  plain.reductions.place_origins = false;
  Groups groups;
  std::vector<std::string> choices;
  for (const std::string& name : names) {
    const std::string decides = deciding(scene, name);
    const bool is_solved = decides == "accelerations";
    Way way = is_solved ? of_solved.best(decides).way : depends_on_way(decides) ? of_others.best(decides).way : plain;
    choices.push_back(is_solved ? choice_of(of_solved, decides) : "");
    if (is_derived(scene, name)) std::tie(way, choices.back()) = cheapest_derivative(scene, name, way, size);
    const auto same = [&way](const auto& group) { return group.first == way; };
    const auto known = std::find_if(groups.begin(), groups.end(), same);
    known == groups.end() ? groups.push_back({way, {name}}) : known->second.push_back(name);
  }
  return program_of_groups(groups, scene, names, choices);
}

}  // namespace kanec
