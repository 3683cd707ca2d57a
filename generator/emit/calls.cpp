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

bool is_algorithm(const std::string& function) { return function == "min" || function == "max"; }

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
                   const std::vector<program::Stage>& stages, program::Stage stage) {
  std::string list;
  for (const std::string& function : called_by(program, [&](std::size_t i) { return wanted[i] && stages[i] == stage; }))
    list += (list.empty() ? "  using std::" : ", std::") + function;
  if (list.empty()) return "";
  std::string text;
  for (const std::string& line : wrapped(list + ";", "      ")) text += line + "\n";
  return text;
}

std::vector<std::string> functions_called(const program::Program& program) {
  const std::set<std::string> functions = called_by(program, [](std::size_t) { return true; });
  return {functions.begin(), functions.end()};
}

bool selects(const program::Program& program) {
  return std::any_of(program.nodes.begin(), program.nodes.end(),
                     [](const program::Node& node) { return std::holds_alternative<program::Select>(node); });
}

std::string selection() {
  return "// a where the condition holds, else b. Scalars whose comparison gives no bool bring a select of their own.\n"
         "template <class T>\nconstexpr T select(bool condition, const T& a, const T& b) noexcept {\n"
         "  return condition ? a : b;\n}\n\n";
}

std::string includes(const program::Program& program) {
  std::set<std::string> headers;
  for (const std::string& function : functions_called(program))
    headers.insert(is_algorithm(function) ? "algorithm" : "cmath");
  std::string text;
  for (const std::string& header : headers) text += "#include <" + header + ">\n";
  return text;
}

}  // namespace kanec::emit
