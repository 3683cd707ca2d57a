// What depends on parameters only: the structs Parameters, Inputs (where there are any) and
// Prepared, and prepare(). Not: functions of the state.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/function.hpp"
#include "generator/emit/used.hpp"

namespace kanec::emit {

struct Preparation {
  Named named;       // "c.Iinv2_11", for functions of the state
  std::string text;  // the structs and prepare()
};

Preparation emit_prepare(const Used& used, const program::Program& program, const std::vector<program::Stage>& stages,
                         const Syntax& syntax);

}  // namespace kanec::emit
