// Angles of the state whose cosines and sines a function takes all at once, before its sections. Not: cosines and sines
// of anything else, which stand where they are needed; nor how they are computed fast (runtime/lanes/cos_sin.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/language.hpp"
#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// Entries of x, ascending.
class Angles {
 public:
  // Those that the function takes the cosine or sine of. None where they are fewer than two.
  Angles(const program::Program& program, const program::Function& function, Optimize optimize);

  bool has(program::Index entry) const;
  bool empty() const { return entries_.empty(); }

  // Of the nodes that are wanted those that are not a cosine or sine of these.
  std::vector<bool> others(const program::Program& program, std::vector<bool> wanted) const;

  // "  T cosines[8], sines[8];\n": entry i belongs to x[i]. Empty where there are no angles, as are the others.
  std::string declarations(const Syntax& syntax, const std::string& indent) const;
  // "  cos_sin(x + 4, 4, cosines + 4, sines + 4);\n" for every run of neighbours; the arrays are members of `owner`,
  // "shared."
  std::string calls(const Syntax& syntax, const std::string& owner) const;

 private:
  std::vector<program::Index> entries_;
  bool small_;  // the model's own cos_sin()
};

// Whether any function calls cos_sin().
bool takes_turns(const Model& model, const program::Program& program);

// A cos_sin() of the model's own that is a loop over the library's functions, where code is to be small and functions
// call one; else empty.
std::string small_cos_sin(const Model& model, const program::Program& program);

}  // namespace kanec::emit
