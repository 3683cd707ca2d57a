// One kind of section of a rolled function as tables and a function that takes a row of them. Not: the loop
// that calls it (rolled.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/angles.hpp"
#include "generator/emit/function.hpp"
#include "generator/emit/language.hpp"
#include "generator/program/rolled.hpp"

namespace kanec::emit {

// What all sections of a function have in common.
struct RolledScope {
  const Model* model = nullptr;
  const program::Program* program = nullptr;
  const program::Function* function = nullptr;
  const program::Rolled* rolled = nullptr;
  const Named* named = nullptr;
  Syntax syntax, inner;             // of the model, and of what this function is made of
  std::vector<std::string> fields;  // names of the frame's
  Angles angles;                    // of which the arrays cosines and sines are
};

// Results of parameters, and inputs, that some section reads by a table, as arrays: by node or index their place.
struct Gathered {
  std::map<program::Index, program::Index> prepared, inputs;
};

struct SectionText {
  std::string name;    // "outward_3"
  std::string tables;  // constant arrays, empty where all bodies are alike
  std::string function;
  std::string arguments;  // of a call: "x, frames, row", each the name of what is meant
};

// number: among the kinds of this pass, from 1.
SectionText section_text(const RolledScope& scope, const program::SectionClass& kind, int number, Gathered& gathered);

// "outward_3"
std::string section_name(const program::SectionClass& kind, int number);

}  // namespace kanec::emit
