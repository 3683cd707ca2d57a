// Names of one emitted function, each given once. Not: what they stand for (statements.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_set>

#include "generator/program/program.hpp"

namespace kanec::emit {

class Syntax;

class Scope {
 public:
  // Taken by what stands around: arguments, arrays, functions called.
  void reserve(const std::string& name) { taken_.insert(name); }

  // `wish`, or where something else bears that "<wish>_2", "<wish>_3", ...; taken from now on.
  std::string unique(const std::string& wish);

 private:
  std::unordered_set<std::string> taken_;
};

// What a function over the state has around it: its arguments and results, the entries of these that it reads, by name,
// and the library functions that the program calls.
Scope function_scope(const program::Program& program, const program::Function& function, const Syntax& syntax);

}  // namespace kanec::emit
