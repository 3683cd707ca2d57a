// The comment that an emitted header opens with: bodies and joints, state, loads left out, conventions, operations.
// Not: code.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/model.hpp"
#include "generator/emit/used.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// costs: of the program's functions, in order.
std::string preamble(const Model& model, const program::Program& program, const Used& used,
                     const std::vector<program::Ledger>& costs);

}  // namespace kanec::emit
