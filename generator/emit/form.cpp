// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/form.hpp"

#include <algorithm>
#include <utility>

namespace kanec::emit {
namespace {

// More stores of constants, of which loops spare none, than operations: a matrix of many bodies that have nothing to do
// with each other.
bool is_mostly_constant(const program::Program& program, const program::Function& function,
                        const program::Ledger& cost) {
  const auto n = std::count_if(function.outputs.begin(), function.outputs.end(), [&](program::Ref output) {
    return std::holds_alternative<program::Constant>(program.nodes[static_cast<std::size_t>(output.node)]);
  });
  return n >= cost.operations() + cost.square_roots + cost.trigonometric + cost.functions;
}

Form form(const program::Program& program, const program::Function& function, const program::Ledger& cost,
          const Model& model) {
  Form result;
  const Optimize optimize = model.optimize;
  if (optimize == Optimize::line) return result;
  if (optimize == Optimize::speed && cost.operations() <= model.longest_line) return result;
  if (optimize != Optimize::loops && is_mostly_constant(program, function, cost)) return result;
  std::optional<program::Rolled> loops = program::rolled(program, function);
  if (!loops) return result;
  result.straight = straight_footprint(program, function);
  result.rolled = rolled_footprint(*loops);
  if (optimize == Optimize::loops) {
    result.loops = std::move(loops);
    return result;
  }
  // a tenth less is within what the estimate knows
  const bool pays = optimize == Optimize::size
                        ? result.rolled.code < result.straight.code / 10 * 9
                        : result.rolled.code < result.straight.code / 2 && result.rolled.stack <= most_stack;
  if (pays) result.loops = std::move(loops);
  return result;
}

std::string bytes(const program::Footprint& footprint) {
  return std::to_string(footprint.code) + " of code, " + std::to_string(footprint.stack) + " of stack";
}

}  // namespace

std::vector<Form> forms(const program::Program& program, const std::vector<program::Ledger>& costs,
                        const Model& model) {
  std::vector<Form> result;
  for (std::size_t i = 0; i < program.functions.size(); ++i)
    result.push_back(form(program, program.functions[i], costs[i], model));
  return result;
}

std::string memory(const program::Program& program, const std::vector<Form>& forms) {
  std::string text;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (!forms[i].loops) continue;
    const std::string& name = program.functions[i].name;
    text += "//   " + name + ": " + std::to_string(forms[i].loops->steps.size()) + " sections of " +
            std::to_string(forms[i].loops->classes.size()) + " kinds; " + bytes(forms[i].rolled) +
            "\n//     as a straight line: " + bytes(forms[i].straight) + "\n";
  }
  return text.empty() ? "" : "//\n// functions written as loops over bodies; bytes in double, estimated:\n" + text;
}

}  // namespace kanec::emit
