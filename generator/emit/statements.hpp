// Nodes of a program as statements: which results get a name, which stand inside an expression. Not: functions and
// files.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "generator/emit/language.hpp"
#include "generator/emit/scope.hpp"
#include "generator/emit/term.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// The name of a node's value, or of its negative.
struct Name {
  std::string text;
  bool negative = false;
};

// A number as C and C++ read it back: "0.1", "2", "12345678901234567168.0" where an integer literal would be too large.
std::string literal(double value);

// A line broken at blanks to the width of the emitted code; further lines begin with `indent`. Blanks that hold
// together what stands on either side are written `no_break` and become blanks.
inline constexpr char no_break = '\v';
std::vector<std::string> wrapped(const std::string& text, const std::string& indent);

// Prints one function's nodes of one stage. Names given once stay; a node that is used more than once and has none gets
// a numbered temporary.
class Statements {
 public:
  // roots: what the function returns. Nodes of another stage must have names before they are used. scope: names that
  // are taken.
  Statements(const program::Program& program, const std::vector<program::Stage>& stages, program::Stage stage,
             const std::vector<program::Ref>& roots, Scope scope, Syntax syntax);

  bool needs(program::Ref ref) const { return alive_[at(ref.node)]; }
  bool has_name(program::Ref ref) const { return names_.count(ref.node) > 0; }
  void name(program::Index node, Name name) { names_[node] = std::move(name); }

  // The cosine and sine of this variable are taken elsewhere: in the arrays cosines and sines at `place`, "[4]".
  void take_turn(program::Index variable, std::string place) { turns_[variable] = std::move(place); }

  // Temporaries are numbered from 1 behind this prefix from now on.
  void number_temporaries(const std::string& prefix);

  // Appends "const T <label> = <expression>;" where the node has no name yet, and temporaries before it. Where the
  // program holds the negative of the value, that is named, "minus_<label>": no operation is spent on a sign. A label
  // that another result bears gets a number behind. Nothing where the one expression that uses it is written already.
  void define(const std::string& label, program::Ref ref);
  // The expression of a value, after temporaries that it needs.
  std::string value(program::Ref ref);

  void line(const std::string& text);  // wrapped and indented
  // What was appended since, and the variables read since.
  std::vector<std::string> take_lines();
  std::vector<program::Variable> take_variables();
  // Names of results made and used since, prepared parameters not among them.
  std::vector<std::string> take_defined();
  std::vector<std::string> take_used();

 private:
  static std::size_t at(program::Index index) { return static_cast<std::size_t>(index); }
  void count_uses(const std::vector<program::Ref>& roots);
  void make_temporaries(program::Index node);
  std::string temporary() { return prefix_ + std::to_string(++temporaries_[prefix_]); }
  Term expression(program::Index node);
  Term operation(const program::Node& node);
  Term call(const program::UnaryCall& op);
  Term turn(const char* array, const char* function, program::Index a);
  Term odd(const char* function, program::Index a);
  Term even(const char* function, program::Index a);
  Term selection(const program::Select& op);
  std::string argument(program::Index a) { return text(expression(a)); }

  const program::Program& program_;
  const std::vector<program::Stage>& stages_;
  program::Stage stage_;
  Scope scope_;
  Syntax syntax_;
  std::vector<bool> alive_;
  std::vector<int> uses_;
  std::vector<bool> written_;  // without a name, in the expression that alone uses it
  std::unordered_map<program::Index, Name> names_;
  std::unordered_map<program::Index, std::string> turns_;
  std::string prefix_ = "t";
  std::unordered_map<std::string, int> temporaries_;  // made so far, by prefix
  std::vector<std::string> lines_;
  std::vector<program::Variable> variables_;
  std::vector<std::string> defined_, used_;
};

// Name of an argument's entry: "eps1_2", "u.thrust", "c.p.m_1".
std::string variable_name(const program::Program& program, const program::Variable& variable, program::Stage stage,
                          const Syntax& syntax);

}  // namespace kanec::emit
