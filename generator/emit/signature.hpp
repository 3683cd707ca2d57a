// The argument lists of emitted functions. Not: their bodies.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/program/program.hpp"

namespace kanec::emit {

using program::Signature;

// Which arguments a body reads; the others are marked [[maybe_unused]].
struct Reads {
  bool prepared = false, x = false, y = false, ydot = false, inputs = false;
};

// "const Prepared<T>& c, const T* x, T* xdot"
std::string parameter_list(const Signature& signature, const Reads& reads);
// "c, x, xdot" with the given expressions for the prepared parameters and the inputs
std::string argument_list(const Signature& signature, const std::string& prepared, const std::string& inputs,
                          const std::string& out);

}  // namespace kanec::emit
