// Jacobians by elimination of intermediate results from the graph of partial derivatives. Not: forward differentiation,
// which is `Tangents`. After Griewank and Walther, Evaluating Derivatives, 2nd ed., chapters 9 and 10.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/derivative.hpp"

namespace kanec::program {

// The result that goes next: the last one, which is reverse differentiation, or the one that takes the fewest products
// (after Markowitz).
enum class Order { outputs_first, fewest_products };

// The entries of the Jacobian, row-major, appended to the builder. Here the derivative of a selection is 0 or 1 times
// that of its values: where one that is not selected is infinite, only `Tangents` is right.
std::vector<Ref> jacobian_entries(Builder& builder, const std::vector<Ref>& outputs, const std::vector<Column>& columns,
                                  Order order);

}  // namespace kanec::program
