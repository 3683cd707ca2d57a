// Arguments of each emitted function and the layout of its result. Not: what it computes.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::emit {

struct Signature {
  bool x, y, ydot, inputs;
  const char* out;     // name of the result
  const char* layout;  // "rates of y (ny) [rad/s^2], [m/s^2]"
};

// Throws InternalError for a function that has none.
const Signature& signature(const std::string& function);

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
