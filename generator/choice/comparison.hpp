// Ways to compute some functions of a scene, side by side: what each costs, and how many digits it loses. Not: which
// ways are worth a try (candidates.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec {

// Masses of so many links come together where all of them would lose digits. Three, as the axes of many chains repeat
// after three links: what repeats can be emitted as a loop.
inline constexpr int few_links = 3;

struct Candidate {
  symbolic::Way way;
  program::Ledger cost;
  double error = 0.0;  // expected, in ulps: the median over some states; infinite where it costs too much anyway
};

// Of accelerations errors are compared too. Others are sums that lose some ulps in every way.
class Comparison {
 public:
  // `base`: what all ways leave out at most.
  Comparison(const scene::Scene& scene, const symbolic::Reductions& base, std::vector<std::string> names);

  void add(const symbolic::Way& way);
  // Ways that would be cheaper, if they did not lose digits, with few masses together.
  void add_mended();

  // The cheapest that loses no digits. Whatever other functions are compared, it is the same: the best algorithm and
  // axes with all that can be left out, then the best of what may stay in.
  const Candidate& best(const std::string& name) const;
  // The same of those that pass the filter; null where there is none.
  using Filter = std::function<bool(const symbolic::Way&)>;
  const Candidate* best(const std::string& name, const Filter& filter) const;
  // Of all functions, each way once.
  std::vector<symbolic::Way> best_ways() const;

 private:
  const std::vector<Candidate>& candidates(const std::string& name) const;
  double error(const program::Program& program, std::size_t number, long cost) const;
  bool is_known(const symbolic::Way& way) const;

  const scene::Scene& scene_;
  symbolic::Reductions base_;
  std::vector<std::string> names_;
  std::vector<program::Arguments<double>> states_;  // in which errors are compared
  std::vector<std::vector<Candidate>> candidates_;  // by name
};

}  // namespace kanec
