// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/sparsity.hpp"

#include <vector>

#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

bool is_zero(const program::Program& program, program::Ref ref) {
  const auto* constant = std::get_if<program::Constant>(&program.nodes[static_cast<std::size_t>(ref.node)]);
  return constant != nullptr && constant->value == program::Number(0.0);
}

// A list of one 0 where there is none: C++ has no empty arrays.
std::string list(const std::string& name, const std::vector<program::Index>& values) {
  std::string text = "inline constexpr int " + name + "[] = {";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(values[i]);
  std::string lines;
  for (const std::string& line : wrapped(text + (values.empty() ? "0" : "") + "};", "    ")) lines += line + "\n";
  return lines;
}

}  // namespace

std::string sparsity(const program::Program& program, const program::Function& function) {
  const program::Index columns = function.signature.columns;
  if (columns == 0 || !function.placements.empty()) return "";
  std::vector<program::Index> row_of, column_of;
  for (program::Index i = 0; i < function.n_out; ++i) {
    if (is_zero(program, function.outputs[static_cast<std::size_t>(i)])) continue;
    row_of.push_back(i / columns);
    column_of.push_back(i % columns);
  }
  const std::string& name = function.name;
  return "// Entries of " + name + " that are not always 0, row by row.\ninline constexpr int " + name +
         "_nonzeros = " + std::to_string(row_of.size()) + ";\n" + list(name + "_rows", row_of) +
         list(name + "_columns", column_of) + "\n";
}

}  // namespace kanec::emit
