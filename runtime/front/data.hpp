// What the front door's classes hold, and what their files share. Not: what they do.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kanec/model.hpp"
#include "runtime/abi/solver.hpp"

namespace kanec {

struct Evaluator::Data {
  explicit Data(Solver made) : solver(std::move(made)) {}
  Solver solver;
};

// "kinematics_and_accelerations" of "kinematics+accelerations".
std::string emitted_word(std::string_view request);

// Throws InputError unless the model has it where it says.
void require_of(const kanec_model& model, const Function& function);

// The place of a name; throws InputError that names the nearest.
int named(const char* what, const char* const* names, int count, std::string_view name);

std::vector<double> values_of(const std::vector<Quantity>& list);

void require_finite(const char* what, std::span<const double> values);

}  // namespace kanec
