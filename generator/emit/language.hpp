// What differs between the languages that functions are printed in: C++17, templates over the scalar in a namespace;
// and C99, static functions whose names begin with the model's. Not: statements, functions and files themselves.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/model.hpp"

namespace kanec::emit {

class Syntax {
 public:
  Syntax() = default;  // C++
  explicit Syntax(const Model& model);

  bool is_c() const { return language_ == Language::c; }

  // --- scalars

  std::string scalar() const { return is_c() ? "kanec_real" : "T"; }
  // A constant, or an entry of a table of numbers, as a scalar: "T(0.5)", "(kanec_real)0.5".
  std::string number(const std::string& text) const { return is_c() ? "(kanec_real)" + text : "T(" + text + ")"; }
  // What stands before the parenthesis of a call of a library function, or of min, max and select.
  std::string call(const std::string& function) const;

  // --- names

  // Of what stands outside of functions: "nx", "cart_pole_nx".
  std::string global(const std::string& name) const { return prefix_ + name; }
  // A type over the scalar: "Prepared<T>", "cart_pole_Prepared".
  std::string type(const std::string& name) const { return is_c() ? prefix_ + name : name + "<T>"; }
  // A namespace within the model's, or what C has of one; its names as they are called in it and outside.
  Syntax within(const std::string& space) const;
  std::string from_outside(const std::string& space, const std::string& name) const;
  std::string open(const std::string& space) const { return is_c() ? "" : "namespace " + space + " {\n"; }
  std::string close(const std::string& space) const { return is_c() ? "" : "}  // namespace " + space + "\n"; }

  // Of a struct that a function is given: "c.p", "c->p".
  std::string member(const std::string& of, const std::string& field) const {
    return of + (is_c() ? "->" : ".") + field;
  }

  // --- functions

  // A struct that is only read, or that is written: "const Prepared<T>& c", "cart_pole_f_Shared* shared".
  std::string given(const std::string& type, const std::string& name) const;
  std::string written(const std::string& type, const std::string& name) const {
    return type + (is_c() ? "* " : "& ") + name;
  }
  // A parameter that may be unused: marked so, or told by a statement that these are used.
  std::string maybe_unused(const std::string& parameter) const {
    return (is_c() ? "" : "[[maybe_unused]] ") + parameter;
  }
  std::string unused(const std::vector<std::string>& names, const std::string& indent = "  ") const;
  // Up to the brace, and what `unused` says. Apart: never part of what calls it.
  std::string opening(const std::string& result, const std::string& name, const std::string& parameters,
                      const std::vector<std::string>& unused, bool apart = false) const;

  // --- constants and types

  // Whole numbers "nx = 2, ny = 2", of names as global() gives them, as lines.
  std::string constants(const std::string& list) const;
  // Up to the list: "inline constexpr int mass_matrix_rows[] = ".
  std::string table(const std::string& type, const std::string& name, const std::string& sizes) const;
  std::string local_table(const std::string& type) const {
    return (is_c() ? "static const " : "static constexpr ") + type;
  }
  std::string open_struct(const std::string& name) const;
  std::string close_struct(const std::string& name) const { return is_c() ? "} " + prefix_ + name + ";\n" : "};\n"; }

 private:
  Language language_ = Language::cpp;
  std::string model_, prefix_;  // "cart_pole_"; empty in C++
};

}  // namespace kanec::emit
