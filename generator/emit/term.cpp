// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/term.hpp"

#include <utility>

namespace kanec::emit {
namespace {

std::string in_parentheses(const Term& term, bool wanted) { return wanted ? "(" + term.text + ")" : term.text; }

}  // namespace

Term sum(Term a, Term b) {
  const bool both = a.negative && b.negative;
  if (a.negative && !both) std::swap(a, b);
  const bool minus = b.negative && !both;
  if (!minus && b.level == 0 && a.level > 0) std::swap(a, b);
  return {a.text + (minus ? " - " : " + ") + in_parentheses(b, b.level == 0), 0, both};
}

Term product(Term a, Term b) {
  if (b.level == 1 && a.level != 1) std::swap(a, b);
  return {in_parentheses(a, a.level == 0) + " * " + in_parentheses(b, b.level < 2), 1, a.negative != b.negative};
}

Term quotient(const Term& a, const Term& b) {
  return {in_parentheses(a, a.level == 0) + " / " + in_parentheses(b, b.level < 2), 1, a.negative != b.negative};
}

Term negated(Term a) {
  a.negative = !a.negative;
  return a;
}

std::string text(const Term& term) { return term.negative ? "-" + in_parentheses(term, term.level == 0) : term.text; }

std::string below_zero(const Term& term, const std::string& zero) {
  const std::string value = in_parentheses(term, term.level == 0);
  return term.negative ? zero + " < " + value : value + " < " + zero;
}

}  // namespace kanec::emit
