// Products that a machine computes together with the addition that takes them in, as one multiply-add. Not: whether a
// compiler does so, which its flags say (-ffp-contract).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// Of each node: a product of the state's stage that sums alone use, once.
std::vector<bool> fusible_products(const Program& program, const std::vector<Stage>& stages);

// Additions of one call of the function that take in a product of their own: so many instructions less.
int multiply_adds(const Program& program, const Function& function);

}  // namespace kanec::program
