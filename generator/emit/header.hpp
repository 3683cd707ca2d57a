// The emitted files: one self-contained header a model, and the source that instantiates it for the runtime.
// Not: how they are compiled (runtime/compile).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// C++17, namespace kanec::<model>, function templates over the scalar; needs nothing but the standard library. Or C99,
// names that begin with the model's, the scalar a macro; needs nothing but <math.h>.
std::string emit_header(const Model& model, const program::Program& program);

// "<model>_abi.cpp": the header's functions in double behind the descriptor of runtime/abi/abi.h.
std::string emit_abi(const Model& model, const program::Program& program);

// "<model>_batch.cpp": the same for lanes, many states a call, with runtime/lanes beside it. The macros KANEC_SCALAR
// (double or float) and KANEC_LANES overrule what it takes otherwise: double, and as many as the target has.
std::string emit_batch(const Model& model, const program::Program& program);

}  // namespace kanec::emit
