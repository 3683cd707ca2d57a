// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/statements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/program/overloaded.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec::emit {
namespace {

using program::Group;
using program::Index;
using program::Node;
using program::Ref;
using program::Stage;

constexpr std::size_t width = 118;

}  // namespace

std::string literal(double value) {
  if (!std::isfinite(value))
    throw InputError("a constant of the model is not finite: its numbers are too large or too small");
  const std::string digits = shortest(value);
  const bool is_whole = digits.find_first_of(".e") == std::string::npos;
  return is_whole && digits.size() > 9 ? digits + ".0" : digits;
}

std::string variable_name(const program::Program& program, const program::Variable& variable, Stage stage,
                          const Syntax& syntax) {
  const auto i = static_cast<std::size_t>(variable.index);
  switch (variable.group) {
    case Group::parameter:
      return stage == Stage::parameter ? syntax.member("p", scene::spelled(program.names.parameters[i]))
                                       : syntax.member("c", "p." + scene::spelled(program.names.parameters[i]));
    case Group::input:
      return syntax.member("u", scene::spelled(program.names.inputs[i]));
    case Group::x:
      return program.names.x[i];
    case Group::y:
      return program.names.y[i];
    case Group::ydot:
      return program.names.ydot[i];
    case Group::time:
      return "t";
  }
  throw InternalError("emit: a variable of no group");
}

Statements::Statements(const program::Program& program, const std::vector<Stage>& stages, Stage stage,
                       const std::vector<Ref>& roots, Scope scope, Syntax syntax)
    : program_(program),
      stages_(stages),
      stage_(stage),
      scope_(std::move(scope)),
      syntax_(std::move(syntax)),
      alive_(reachable(program, roots)) {
  count_uses(roots);
  written_.assign(program.nodes.size(), false);
}

// Uses by the nodes that the roots need and by the roots themselves.
void Statements::count_uses(const std::vector<Ref>& roots) {
  uses_.assign(program_.nodes.size(), 0);
  for (const Ref root : roots) ++uses_[at(root.node)];
  for (std::size_t i = 0; i < program_.nodes.size(); ++i) {
    if (!alive_[i]) continue;
    const program::Operands from = operands(program_.nodes[i]);
    for (int j = 0; j < from.count; ++j) ++uses_[at(from.at[j])];
  }
}

void Statements::number_temporaries(const std::string& prefix) { prefix_ = prefix; }

void Statements::define(const std::string& label, Ref ref) {
  const Stage stage = stages_[at(ref.node)];
  const bool is_operation = operands(program_.nodes[at(ref.node)]).count > 0;
  if (!needs(ref) || has_name(ref) || stage != stage_ || !is_operation || written_[at(ref.node)]) return;
  make_temporaries(ref.node);
  const Term t = operation(program_.nodes[at(ref.node)]);
  const Name given{scope_.unique(ref.negative != t.negative ? "minus_" + label : label), t.negative};
  line("const " + syntax_.scalar() + " " + given.text + " = " + t.text + ";");
  defined_.push_back(given.text);
  name(ref.node, given);
}

std::string Statements::value(Ref ref) {
  make_temporaries(ref.node);
  if (!has_name(ref) && uses_[at(ref.node)] > 1 && operands(program_.nodes[at(ref.node)]).count > 0) {
    define(temporary(), {ref.node, false});
  }
  Term t = expression(ref.node);
  t.negative = t.negative != ref.negative;
  return emit::text(t);
}

// Names for what stands below this node and is used more than once, operands first.
void Statements::make_temporaries(Index node) {
  const program::Operands from = operands(program_.nodes[at(node)]);
  for (int i = 0; i < from.count; ++i) {
    const Index operand = from.at[i];
    const bool is_operation = operands(program_.nodes[at(operand)]).count > 0;
    if (!is_operation || names_.count(operand) > 0 || stages_[at(operand)] != stage_) continue;
    make_temporaries(operand);
    if (uses_[at(operand)] > 1) define(temporary(), {operand, false});
  }
}

Term Statements::expression(Index node) {
  const auto known = names_.find(node);
  if (known != names_.end()) {
    if (stages_[at(node)] == stage_) used_.push_back(known->second.text);
    return {known->second.text, 2, known->second.negative};
  }
  written_[at(node)] = stages_[at(node)] == stage_ && uses_[at(node)] == 1;
  return operation(program_.nodes[at(node)]);
}

Term Statements::operation(const Node& node) {
  return std::visit(
      program::Overloaded{
          [&](const program::Constant& op) -> Term {
            const double value = op.value.rounded();
            return {syntax_.number(literal(std::abs(value))), 2, value < 0};
          },
          [&](const program::Variable& op) -> Term {
            variables_.push_back(op);
            return {variable_name(program_, op, stage_, syntax_), 2, false};
          },
          [&](const program::Add& op) { return sum(expression(op.a), expression(op.b)); },
          [&](const program::Subtract& op) {
            Term b = expression(op.b);
            return sum(expression(op.a), negated(std::move(b)));
          },
          [&](const program::Multiply& op) { return product(expression(op.a), expression(op.b)); },
          [&](const program::Divide& op) {
            const Term a = expression(op.a);
            return quotient(a, expression(op.b));
          },
          [&](const program::SquareRoot& op) -> Term {
            return {syntax_.call("sqrt") + "(" + argument(op.a) + ")", 2, false};
          },
          [&](const program::Sine& op) { return turn("sines", "sin", op.a); },
          [&](const program::Cosine& op) { return turn("cosines", "cos", op.a); },
          [&](const program::UnaryCall& op) { return call(op); },
          [&](const program::BinaryCall& op) -> Term {
            const std::string first = argument(op.a);
            return {syntax_.call(program::name(op.function)) + "(" + first + ", " + argument(op.b) + ")", 2, false};
          },
          [&](const program::Select& op) { return selection(op); },
      },
      node);
}

Term Statements::call(const program::UnaryCall& op) {
  const char* name = program::name(op.function);
  switch (op.function) {
    case program::Unary::tan:
    case program::Unary::asin:
    case program::Unary::tanh:
      return odd(name, op.a);
    case program::Unary::abs:
      return even(name, op.a);
    case program::Unary::acos:
    case program::Unary::exp:
    case program::Unary::log:
      break;
  }
  return {syntax_.call(name) + "(" + argument(op.a) + ")", 2, false};
}

Term Statements::turn(const char* array, const char* function, Index a) {
  const auto taken = turns_.find(a);
  if (taken != turns_.end()) return {array + taken->second, 2, false};
  return function[0] == 's' ? odd(function, a) : even(function, a);
}

// A sign costs nothing where the function is odd or even.
Term Statements::odd(const char* function, Index a) {
  const Term t = expression(a);
  return {syntax_.call(function) + "(" + t.text + ")", 2, t.negative};
}

Term Statements::even(const char* function, Index a) {
  return {syntax_.call(function) + "(" + expression(a).text + ")", 2, false};
}

Term Statements::selection(const program::Select& op) {
  const Term sign = expression(op.sign);
  const std::string first = argument(op.a);
  return {
      syntax_.call("select") + "(" + below_zero(sign, syntax_.number("0")) + ", " + first + ", " + argument(op.b) + ")",
      2, false};
}

void Statements::line(const std::string& text) {
  for (std::string& part : wrapped("  " + text, "      ")) lines_.push_back(std::move(part));
}

std::vector<std::string> wrapped(const std::string& text, const std::string& indent) {
  std::vector<std::string> lines;
  std::string before;  // the indent from the second line on
  std::size_t from = 0;
  while (before.size() + text.size() - from > width) {
    const std::string start = before + text.substr(from, width + 1 - before.size());
    const std::size_t blank = start.rfind(' ');
    if (blank == std::string::npos || start.find_first_not_of(" /") > blank) break;
    lines.push_back(start.substr(0, blank));
    from += blank + 1 - before.size();
    before = indent;
  }
  lines.push_back(before + text.substr(from));
  for (std::string& line : lines) std::replace(line.begin(), line.end(), no_break, ' ');
  return lines;
}

std::vector<std::string> Statements::take_lines() { return std::exchange(lines_, {}); }

std::vector<program::Variable> Statements::take_variables() { return std::exchange(variables_, {}); }

std::vector<std::string> Statements::take_defined() { return std::exchange(defined_, {}); }

std::vector<std::string> Statements::take_used() { return std::exchange(used_, {}); }

}  // namespace kanec::emit
