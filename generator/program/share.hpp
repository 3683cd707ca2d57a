// When two operations are the same one. Not: the pass that makes each once (share.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "generator/program/program.hpp"

namespace kanec::program {

// The kind of node and, of calls, the function.
std::uint64_t operation(const Node& node);

// Whether a and b may change places.
bool commutes(const Node& node);

}  // namespace kanec::program
