// Arguments of each emitted function and the layout of its result. Not: what it computes.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::emit {

struct Signature {
  bool x, y, ydot, inputs;
  const char* out;     // name of the result
  const char* layout;  // "ydot (36): omegadot_1 … omegadot_6 [rad/s^2], sddot_1 … sddot_6 [m/s^2]", sizes in letters
};

// Throws InternalError for a function that has none.
const Signature& signature(const std::string& function);

// Which arguments a body reads; the others are marked [[maybe_unused]].
struct Reads {
  bool prepared = false, x = false, y = false, ydot = false, inputs = false;
};

// "const Prepared<T>& c, const T* x, T* xdot"
std::string parameter_list(const Signature& signature, const Reads& reads);
// "c, x, xdot"
std::string argument_list(const Signature& signature);

}  // namespace kanec::emit
