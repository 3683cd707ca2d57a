// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/calls.hpp"

#include <algorithm>
#include <set>

#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

// Empty where the node calls none.
std::string called(const program::Node& node) {
  if (std::holds_alternative<program::SquareRoot>(node)) return "sqrt";
  if (std::holds_alternative<program::Sine>(node)) return "sin";
  if (std::holds_alternative<program::Cosine>(node)) return "cos";
  if (const auto* call = std::get_if<program::UnaryCall>(&node)) return program::name(call->function);
  if (const auto* call = std::get_if<program::BinaryCall>(&node)) return program::name(call->function);
  return "";
}

bool is_comparison(const std::string& function) { return function == "min" || function == "max"; }

template <class Wanted>
std::set<std::string> called_by(const program::Program& program, Wanted wanted) {
  std::set<std::string> functions;
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (wanted(i)) functions.insert(called(program.nodes[i]));
  functions.erase("");
  return functions;
}

}  // namespace

std::string usings(const program::Program& program, const std::vector<bool>& wanted,
                   const std::vector<program::Stage>& stages, program::Stage stage, const Syntax& syntax) {
  std::string list;
  for (const std::string& function : called_by(program, [&](std::size_t i) { return wanted[i] && stages[i] == stage; }))
    if (!is_comparison(function)) list += (list.empty() ? "  using std::" : ", std::") + function;
  if (list.empty() || syntax.is_c()) return "";
  std::string text;
  for (const std::string& line : wrapped(list + ";", "      ")) text += line + "\n";
  return text;
}

std::vector<std::string> functions_called(const program::Program& program) {
  const std::set<std::string> functions = called_by(program, [](std::size_t) { return true; });
  return {functions.begin(), functions.end()};
}

std::vector<std::string> functions_called(const program::Program& program, const std::vector<program::Stage>& stages,
                                          program::Stage stage) {
  const std::vector<bool> alive = reachable(program);
  const std::set<std::string> functions =
      called_by(program, [&](std::size_t i) { return alive[i] && stages[i] == stage; });
  return {functions.begin(), functions.end()};
}

bool selects(const program::Program& program) {
  return std::any_of(program.nodes.begin(), program.nodes.end(),
                     [](const program::Node& node) { return std::holds_alternative<program::Select>(node); });
}

std::string selection(const Syntax& syntax) {
  const std::string real = syntax.scalar();
  if (syntax.is_c())
    return "// a where the condition holds, else b\nstatic inline " + real + " " + syntax.call("select") +
           "(int condition, " + real + " a, " + real + " b) {\n  return condition ? a : b;\n}\n\n";
  return "// a where the condition holds, else b. Scalars whose comparison gives no bool bring a select of their own.\n"
         "template <class T>\nconstexpr T select(bool condition, const T& a, const T& b) noexcept {\n"
         "  return condition ? a : b;\n}\n\n";
}

bool compares(const program::Program& program) {
  const std::vector<std::string> functions = functions_called(program);
  return std::any_of(functions.begin(), functions.end(), is_comparison);
}

std::string comparisons(const program::Program& program, const Syntax& syntax) {
  if (!compares(program)) return "";
  const std::string real = syntax.scalar(), argument = syntax.is_c() ? real + " " : "const " + real + "& ";
  std::string text = "// a where neither is smaller, or one is not a number";
  text += syntax.is_c() ? "\n" : ". Scalars whose comparison gives no bool bring their own.\n";
  for (const std::string& function : functions_called(program))
    if (is_comparison(function))
      text += (syntax.is_c() ? "static inline " : "template <class T>\nconstexpr ") + real + " " +
              syntax.call(function) + "(" + argument + "a, " + argument + "b) " + (syntax.is_c() ? "" : "noexcept ") +
              "{\n  return " + (function == "min" ? "b < a" : "a < b") + " ? b : a;\n}\n";
  return text + "\n";
}

std::string includes(const program::Program& program, const Syntax& syntax) {
  const std::vector<std::string> functions = functions_called(program);
  if (std::all_of(functions.begin(), functions.end(), is_comparison)) return "";
  return syntax.is_c() ? "#include <math.h>\n" : "#include <cmath>\n";
}

}  // namespace kanec::emit
