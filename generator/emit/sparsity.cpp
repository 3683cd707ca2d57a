// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/sparsity.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

bool is_zero(const program::Program& program, program::Ref ref) {
  const auto* constant = std::get_if<program::Constant>(&program.nodes[static_cast<std::size_t>(ref.node)]);
  return constant != nullptr && constant->value == program::Number(0.0);
}

// A list of one 0 where there is none: C++ has no empty arrays.
std::string list(const std::string& name, const std::vector<program::Index>& values, const Syntax& syntax) {
  std::string text = syntax.table("int", name, "[]") + "{";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(values[i]);
  std::string lines;
  for (const std::string& line : wrapped(text + (values.empty() ? "0" : "") + "};", "    ")) lines += line + "\n";
  return lines;
}

// Of one matrix: what is 0 in one of the functions that return it is 0.
struct Pattern {
  std::string name;
  program::Index columns = 0;
  std::vector<bool> zero;
};

void add(std::vector<Pattern>& list, const program::Program& program, const program::Result& result,
         const program::Ref* entries) {
  const auto is_same = [&result](const Pattern& pattern) { return pattern.name == result.function; };
  auto known = std::find_if(list.begin(), list.end(), is_same);
  if (known == list.end())
    known = list.insert(list.end(), {result.function, result.columns,
                                     std::vector<bool>(static_cast<std::size_t>(result.count), false)});
  for (std::size_t i = 0; i < known->zero.size(); ++i) known->zero[i] = known->zero[i] || is_zero(program, entries[i]);
}

std::string text_of(const Pattern& pattern, const Syntax& syntax) {
  std::vector<program::Index> row_of, column_of;
  for (std::size_t i = 0; i < pattern.zero.size(); ++i) {
    if (pattern.zero[i]) continue;
    row_of.push_back(static_cast<program::Index>(i) / pattern.columns);
    column_of.push_back(static_cast<program::Index>(i) % pattern.columns);
  }
  return "// Entries of " + pattern.name + " that are not always 0, row by row.\n" +
         syntax.constants(syntax.global(pattern.name + "_nonzeros") + " = " + std::to_string(row_of.size())) +
         list(pattern.name + "_rows", row_of, syntax) + list(pattern.name + "_columns", column_of, syntax) + "\n";
}

std::vector<Pattern> patterns_of(const program::Program& program) {
  std::vector<Pattern> patterns;
  for (const program::Function& function : program.functions) {
    if (!function.placements.empty()) continue;
    const program::Ref* entries = function.outputs.data();
    for (const program::Result& result : results(function)) {
      if (result.columns > 0) add(patterns, program, result, entries);
      entries += result.count;
    }
  }
  return patterns;
}

}  // namespace

std::string sparsity(const program::Program& program, const Syntax& syntax) {
  std::string text;
  for (const Pattern& pattern : patterns_of(program)) text += text_of(pattern, syntax);
  return text;
}

PatternTable pattern_table(const program::Program& program) {
  PatternTable table{"const kanec_pattern patterns[] = {\n", 0};
  for (const Pattern& pattern : patterns_of(program)) {
    const std::string of = "model::" + pattern.name;
    table.text += "    {\"" + pattern.name + "\", " +
                  std::to_string(static_cast<program::Index>(pattern.zero.size()) / pattern.columns) + ", " +
                  std::to_string(pattern.columns) + ", " + of + "_nonzeros, " + of + "_rows, " + of + "_columns},\n";
    ++table.size;
  }
  table.text += "    {nullptr, 0, 0, 0, nullptr, nullptr}};\n";
  return table;
}

}  // namespace kanec::emit
