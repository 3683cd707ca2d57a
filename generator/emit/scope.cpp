// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/scope.hpp"

#include "generator/emit/calls.hpp"
#include "generator/emit/language.hpp"
#include "generator/emit/statements.hpp"

namespace kanec::emit {

std::string Scope::unique(const std::string& wish) {
  std::string name = wish;
  for (int i = 2; !taken_.insert(name).second; ++i) name = wish + "_" + std::to_string(i);
  return name;
}

Scope function_scope(const program::Program& program, const program::Function& function, const Syntax& syntax) {
  Scope scope;
  for (const char* name : {"T", "c", "t", "x", "y", "ydot", "u", "i", "j", "block", "place", "places", "shared",
                           "cosines", "sines", "cos_sin", "select"})
    scope.reserve(name);
  scope.reserve(syntax.scalar());
  for (const program::Result& result : results(function)) scope.reserve(result.out);
  const std::vector<bool> alive = reachable(program, function.outputs);
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (const auto* variable = std::get_if<program::Variable>(&program.nodes[i]); variable != nullptr && alive[i])
      scope.reserve(variable_name(program, *variable, program::Stage::state, syntax));
  for (const std::string& name : functions_called(program)) scope.reserve(name);
  return scope;
}

}  // namespace kanec::emit
