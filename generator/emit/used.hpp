// The parameters and inputs that any emitted function reads; others are left out of the emitted code. Not: which
// function reads which.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::emit {

// In the scene's order. Where a function has a column an input, all inputs count as read.
struct Used {
  std::vector<scene::Named> parameters, inputs;
  std::vector<scene::Named> left_out;  // parameters, then inputs
};

Used used(const scene::Scene& scene, const program::Program& program);

}  // namespace kanec::emit
