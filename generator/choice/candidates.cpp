// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/candidates.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "generator/choice/comparison.hpp"
#include "generator/lower/derivatives.hpp"
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
// A is eliminated up to so many triples: its entries are as many products, even where they are numbers.
constexpr long most_triples = 1'000'000;

struct Size {
  int links = 0;
  int pairs = 0;     // of links of which one moves the other, about the blocks of A
  long triples = 0;  // of links of which one moves both others, about the products of an elimination
  bool has_balls = false;
};

Size size_of(const scene::Scene& scene, const Reductions& base) {
  const symbolic::Mechanism mechanism = symbolic::mechanism(scene, base);
  Size size{mechanism.size(), 0, 0, mechanism.has_balls()};
  for (int j = 1; j <= mechanism.size(); ++j) {
    long depth = 0;
    for (int k = j; k > 0; k = mechanism.link(k).lower) size.triples += ++depth;
    size.pairs += static_cast<int>(depth);
  }
  return size;
}

bool may_be_composite(const Size& size) { return size.pairs <= std::max(most_pairs, most_pairs_a_link * size.links); }

// The function whose cost decides on the way of a requested one: accelerations where it has a part in it, else what it
// is derived from, else itself.
std::string deciding(const scene::Scene& scene, const std::string& name) {
  std::string result;
  for (const std::string& part : parts(name)) {
    const std::optional<lower::Derived> derived = lower::derived_function(scene, part);
    const std::string of = !derived ? part : derived->by.front() == "ydot" ? "mass_matrix" : derived->of;
    if (result.empty() || of == "accelerations") result = of;
  }
  return result;
}

// Of all others every way is the same, but for origins, which do best where they are.
bool depends_on_way(const std::string& deciding) {
  return deciding == "residual" || deciding == "forcing" || deciding == "mass_matrix";
}

void add_all(Comparison& comparison, const std::vector<Algorithm>& algorithms, const Size& size,
             const Reductions& base) {
  for (const Algorithm algorithm : algorithms) {
    comparison.add({base, algorithm, Axes::inertial});
    if (size.has_balls) comparison.add({base, algorithm, Axes::body});
  }
  comparison.add_mended();
  if (size.pairs > few_pairs) return;
  // where origins stay and masses are not regrouped: only in what is best otherwise
  for (Way way : comparison.best_ways())
    for (const auto& [place, regroup] : {std::pair(false, true), {true, false}, {false, false}}) {
      way.reductions = base;
      way.reductions.place_origins = base.place_origins && place;
      way.reductions.regroup = base.regroup && regroup;
      comparison.add(way);
    }
  for (Way way : comparison.best_ways()) {
    way.reductions.turn_axes = false;
    comparison.add(way);
  }
  comparison.add_mended();
}

// "4.2"
std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// Which algorithm is kept; nothing where there was no choice, or no difference.
std::string choice_of(const Comparison& comparison, const std::string& name) {
  const Candidate& kept = comparison.best(name);
  const Algorithm other = kept.way.algorithm == Algorithm::composite ? Algorithm::articulated : Algorithm::composite;
  const Candidate* next = comparison.best(name, [other](const Way& way) { return way.algorithm == other; });
  if (next == nullptr || next->cost == kept.cost) return "";
  const std::string text =
      kanec::name(kept.way.algorithm) + "; " + kanec::name(other) + " would take " + program::text(next->cost);
  if (weighted_cost(next->cost) >= weighted_cost(kept.cost)) return text;
  return text + ", and err by " + short_text(next->error) + " ulps instead of " + short_text(kept.error);
}

bool is_derived(const scene::Scene& scene, const std::string& name) {
  const std::vector<std::string> of = parts(name);
  return std::any_of(of.begin(), of.end(),
                     [&](const std::string& part) { return lower::derived_function(scene, part).has_value(); });
}

std::string words(symbolic::Derivatives derivatives) {
  return derivatives == symbolic::Derivatives::equations ? "equations differentiated" : "operations differentiated";
}

// Of the ways to make a derivative the one with the fewest operations; of what it is made of the way is known.
Chosen cheapest_derivative(const scene::Scene& scene, const std::string& name, Way way, const Size& size) {
  Comparison comparison(scene, way.reductions, {name});
  comparison.add(way);
  if (size.triples > most_triples) return {way, ""};
  way.derivatives = symbolic::Derivatives::equations;
  comparison.add(way);
  if (way.algorithm == Algorithm::articulated && may_be_composite(size)) {
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
                                   const std::vector<std::string>& names, const std::vector<Chosen>& chosen) {
  program::Program all;
  std::vector<std::string> order;
  for (const auto& [way, some] : groups) {
    program::Program part = program::optimized(program_of(scene, some, way));
    all = order.empty() ? std::move(part) : program::joined(std::move(all), std::move(part));
    order.insert(order.end(), some.begin(), some.end());
  }
  std::vector<program::Function> functions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), names[i]) - order.begin());
    functions.push_back(std::move(all.functions[at]));
    functions.back().choice = chosen[i].choice;
  }
  all.functions = std::move(functions);
  if (groups.size() == 1) return all;
  // what prepare() does is shared; the calls are left as they are, whatever others there are
  return program::drop_dead(scene.parameters.empty() ? std::move(all) : program::share(std::move(all)));
}

}  // namespace

std::string name(Algorithm algorithm) { return algorithm == Algorithm::composite ? "composite" : "articulated"; }

std::vector<Chosen> choose_ways(const scene::Scene& scene, const std::vector<std::string>& names,
                                std::optional<Algorithm> algorithm, const Reductions& all) {
  const Size size = size_of(scene, all);
  // of long chains it is known that accelerations lose digits where all masses are gathered
  Reductions for_solved = all;
  if (size.pairs > few_pairs) for_solved.group = std::min(all.group, few_links);
  std::vector<std::string> solved, others;
  for (const std::string& name : names) {
    const std::string decides = deciding(scene, name);
    if (decides == "accelerations") insert(solved, decides);
    if (depends_on_way(decides)) insert(others, decides);
  }
  std::vector<Algorithm> algorithms = {Algorithm::articulated};
  if (may_be_composite(size)) algorithms.push_back(Algorithm::composite);
  if (algorithm) algorithms = {*algorithm};
  Comparison of_solved(scene, for_solved, solved), of_others(scene, all, others);
  add_all(of_solved, algorithms, size, for_solved);
  add_all(of_others, {Algorithm::composite}, size, all);

  Way plain{all};
  plain.reductions.place_origins = plain.reductions.turn_axes = false;
  std::vector<Chosen> chosen;
  for (const std::string& name : names) {
    const std::string decides = deciding(scene, name);
    if (decides == "accelerations")
      chosen.push_back({of_solved.best(decides).way, choice_of(of_solved, decides)});
    else
      chosen.push_back({depends_on_way(decides) ? of_others.best(decides).way : plain});
    if (is_derived(scene, name)) chosen.back() = cheapest_derivative(scene, name, chosen.back().way, size);
  }
  return chosen;
}

program::Program cheapest_program(const scene::Scene& scene, const std::vector<std::string>& names,
                                  std::optional<Algorithm> algorithm, const Reductions& all) {
  const std::vector<Chosen> chosen = choose_ways(scene, names, algorithm, all);
  Groups groups;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto same = [&](const auto& group) { return group.first == chosen[i].way; };
    const auto known = std::find_if(groups.begin(), groups.end(), same);
    known == groups.end() ? groups.push_back({chosen[i].way, {names[i]}}) : known->second.push_back(names[i]);
  }
  return program_of_groups(groups, scene, names, chosen);
}

}  // namespace kanec
