// Operations simplified as they are written down: constants folded exactly, zeros and ones eliminated, signs taken out.
// Not: a pass over a program (simplify.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "generator/program/builder.hpp"
#include "generator/program/passes.hpp"

namespace kanec::program::fold {

// The value of a reference to a constant.
std::optional<Number> value(const Builder& builder, Ref ref);
bool is(const Builder& builder, Ref ref, double wanted);

// A constant by its magnitude, so that c and -c are one literal.
Ref literal(Builder& builder, const Number& number);

Ref sum(Builder& builder, Ref a, Ref b);
Ref product(Builder& builder, Ref a, Ref b);
Ref quotient(Builder& builder, Ref a, Ref b);

// Functions at 0 and 1 where the result is exact; powers with whole exponents up to 8 by multiplication.
Ref square_root(Builder& builder, Ref a);
Ref sine(Builder& builder, Ref a);
Ref cosine(Builder& builder, Ref a);
Ref call(Builder& builder, Unary function, Ref a);
Ref call(Builder& builder, Binary function, Ref a, Ref b);
Ref select(Builder& builder, Ref sign, Ref a, Ref b);

// The node itself on new operands, by the above.
Ref again(Builder& builder, const Node& node, const Refs& operands);

}  // namespace kanec::program::fold
