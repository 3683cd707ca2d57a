// What stands around the functions of an emitted C header: its guard, the scalar, the library's functions by it. Not:
// the functions.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// From the guard on; with cos_sin() where functions call it. apart: whether some function is made of others.
std::string c_beginning(const Model& model, const program::Program& program, bool apart);
std::string c_end(const program::Program& program, bool apart);

}  // namespace kanec::emit
