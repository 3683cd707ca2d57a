// A model compiled with its Taylor series. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/compile/compile.hpp"

namespace kanec::test {

// Kinematics and accelerations in one function, with power where the scene has it.
std::vector<std::string> all_rates(const scene::Scene& scene);

// With every warning an error. Without series where `generated` has none.
compile::Model compiled(const Generated& generated, const scene::Scene& scene);

}  // namespace kanec::test
