// Bytes of machine code and tables of an emitted function, from its library's symbols. Not: constants that stand in no
// table, or what it calls in other libraries.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "runtime/compile/compile.hpp"

namespace kanec {

// With the pieces that a long function is cut into, or the sections that it loops over; nothing where the library has
// no symbols of its own (compiled with -s).
std::optional<std::size_t> code_bytes(const compile::Model& model, const std::string& function);

}  // namespace kanec
