// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/spelling.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kanec::scene {
namespace {

// Macros without arguments; and min and max, which have some, but are told apart by no reader.
constexpr std::array<std::string_view, 44> words = {
    // <complex.h>
    "I", "complex", "imaginary",
    // <windows.h> and what it includes
    "near", "far", "small", "hyper", "interface", "pascal", "cdecl", "min", "max", "IN", "OUT", "OPTIONAL", "CALLBACK",
    "DELETE", "ERROR", "CONST", "VOID", "STRICT", "grp1", "psh1", "chx1", "rad1", "stc1", "lst1", "cmb1", "edt1",
    "scr1", "ctl1",
    // <X11/X.h>
    "None", "Above", "Below", "Success", "Complex", "Convex", "Status", "Always", "Never",
    // of C, or of compilers
    "restrict", "typeof", "typeof_unqual", "huge"};

}  // namespace

std::string spelled(const std::string& name) {
  const bool is_word = std::find(words.begin(), words.end(), name) != words.end();
  return is_word ? name + "_" : name;
}

bool is_spelling(const std::string& name) {
  return !name.empty() && name.back() == '_' && spelled(name.substr(0, name.size() - 1)) == name;
}

}  // namespace kanec::scene
