// An expression as text with what is needed to put it into another: how tightly it binds, and its sign. Not: where the
// text of operands comes from.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::emit {

struct Term {
  std::string text;
  int level = 2;  // 0 sum, 1 product, 2 single
  bool negative = false;
};

// Keeps the association of the program: a sum on the right stands in parentheses, unless the two can change places.
Term sum(Term a, Term b);
Term product(Term a, Term b);
Term quotient(const Term& a, const Term& b);
Term negated(Term a);

// With its sign.
std::string text(const Term& term);

// The condition term < 0; `zero` as it is written.
std::string below_zero(const Term& term, const std::string& zero);

}  // namespace kanec::emit
