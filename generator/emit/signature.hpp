// The argument lists of emitted functions. Not: their bodies.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/language.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// Which arguments a function reads, or takes.
struct Reads {
  bool prepared = false, time = false, x = false, y = false, ydot = false, inputs = false;
};

Reads reads(const program::Program& program, const program::Function& function);

// A function takes the prepared parameters, the time where it reads it, and x, y, ydot and inputs where its signature
// says so or it reads them; inputs only where the model has any.
class ArgumentList {
 public:
  ArgumentList(const program::Program& program, const program::Function& function, bool has_inputs, Syntax syntax = {});

  // "const Prepared<T>& c, T t, const T* x, T* xdot"; what is not read is marked [[maybe_unused]], or in C among the
  // unused.
  std::string parameters() const { return list(reads_, false).text; }
  std::vector<std::string> unused() const { return list(reads_, false).unused; }
  bool takes_inputs() const { return takes_.inputs; }
  // The same where anything may be unused.
  std::string piece_parameters() const { return list({}, true).text; }
  std::vector<std::string> piece_unused() const { return list({}, true).unused; }
  // "c, t, x, xdot" with the given expressions; a pointer `out` to all results is given on in parts.
  std::string values(const std::string& prepared, const std::string& inputs) const;
  std::string values(const std::string& prepared, const std::string& inputs, const std::string& out) const;

 private:
  struct List {
    std::string text;
    std::vector<std::string> unused;
  };
  List list(const Reads& read, bool any_unused) const;
  std::string front(const std::string& prepared, const std::string& inputs) const;

  std::vector<program::Result> results_;
  Reads reads_, takes_;
  Syntax syntax_;
};

}  // namespace kanec::emit
