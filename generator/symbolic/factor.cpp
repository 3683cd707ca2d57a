// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/factor.hpp"

#include <algorithm>
#include <map>

#include "generator/symbolic/order.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

enum class End { left, right };

const ex& outer(const Term& term, End end) { return end == End::left ? term.factors.front() : term.factors.back(); }

struct Common {
  ex factor;
  End end = End::left;
  bool alone = false;  // of terms that have no other factor: numbers and blocks make no sum
  std::size_t count = 1;

  bool is_of(const Term& term) const {
    if (term.factors.empty() || (term.factors.size() == 1) != alone) return false;
    return outer(term, end).is_equal(factor);
  }
};

// The factor at an end of most terms; at equal counts the right end, then the fixed order of letters.
Common most_common(const std::vector<Term>& terms) {
  Common best;
  for (const End end : {End::right, End::left}) {
    std::map<ex, std::size_t, GiNaC::ex_is_less> counts[2];  // of terms that have more, that have no other factor
    for (const Term& term : terms)
      if (!term.factors.empty()) ++counts[term.factors.size() == 1][outer(term, end)];
    for (const Term& candidate : terms) {
      if (candidate.factors.empty()) continue;
      Common common{outer(candidate, end), end, candidate.factors.size() == 1};
      common.count = counts[common.alone].at(common.factor);
      if (common.count < best.count) continue;
      const bool tie =
          common.count == best.count && common.count > 1 && end == best.end && precedes(common.factor, best.factor);
      if (common.count > best.count || tie) best = common;
    }
  }
  return best;
}

Term without(Term term, End end) {
  term.factors.erase(end == End::left ? term.factors.begin() : term.factors.end() - 1);
  return term;
}

// By its numeric factor: -2 m is, 1/m and m1 - m2 are not.
bool is_negative(const Term& term) {
  const auto negative_number = [](const ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_negative();
  };
  if (!GiNaC::is_a<GiNaC::mul>(term.scalar)) return negative_number(term.scalar);
  return std::any_of(term.scalar.begin(), term.scalar.end(), negative_number);
}

// A sum of negative terms as the negative of a sum of positive ones.
ex factored_terms(std::vector<Term> terms) {
  const Common common = most_common(terms);
  if (common.count < 2) return sum(terms);
  if (std::all_of(terms.begin(), terms.end(), is_negative)) {
    for (Term& term : terms) term.scalar = -term.scalar;
    return -factored_terms(terms);
  }
  std::vector<Term> inside;
  std::vector<Term> rest;
  for (const Term& term : terms) {
    if (common.is_of(term))
      inside.push_back(without(term, common.end));
    else
      rest.push_back(term);
  }
  const ex other = factored_terms(inside);
  return (common.end == End::left ? common.factor * other : other * common.factor) + factored_terms(rest);
}

}  // namespace

ex factored(const ex& e) { return factored_terms(expanded(e)); }

}  // namespace kanec::symbolic
