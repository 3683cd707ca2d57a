// What depends on parameters only: the structs Parameters, Inputs and Prepared, and prepare(). Not: functions of the state.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/function.hpp"

namespace kanec::emit {

struct Preparation {
  PreparedNames names;  // "c.Iinv2_11", for functions of the state
  std::string text;     // the structs and prepare()
};

Preparation emit_prepare(const scene::Scene& scene, const program::Program& program,
                         const std::vector<program::Stage>& stages);

}  // namespace kanec::emit
