// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/section.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

using program::Group;
using program::Variable;

std::string array(Group group) { return group == Group::x ? "x" : group == Group::y ? "y" : "ydot"; }

bool is_of_state(Group group) { return group == Group::x || group == Group::y || group == Group::ydot; }

// Entries of the state that no section before has read, a vector a line.
std::string loads(const program::Program& program, const Section& section,
                  std::set<std::pair<Group, program::Index>>& known, const Syntax& syntax) {
  std::set<std::pair<Group, program::Index>> read;
  for (const Variable& v : section.reads)
    if (is_of_state(v.group) && known.insert({v.group, v.index}).second) read.insert({v.group, v.index});
  std::string result;
  std::string vector;
  for (const auto& [group, index] : read) {
    const std::string name = variable_name(program, {group, index}, program::Stage::state, syntax);
    const std::string stem = name.substr(0, name.rfind('_'));
    result += stem == vector ? ", " : (result.empty() ? "" : ";\n") + ("  const " + syntax.scalar() + " ");
    vector = stem;
    result += name + " = " + array(group) + "[" + std::to_string(index) + "]";
  }
  return result.empty() ? "" : result + ";\n";
}

std::string body(const program::Program& program, std::span<const Section> sections, const Syntax& syntax) {
  std::set<std::pair<Group, program::Index>> known;
  std::string text;
  for (const Section& section : sections) {
    if (!section.heading.empty()) text += "\n  // ---- " + section.heading + "\n";
    text += loads(program, section, known, syntax);
    for (const std::string& line : section.lines) text += line + "\n";
  }
  return text;
}

std::size_t length(std::span<const Section> sections) {
  std::size_t lines = 0;
  for (const Section& section : sections) lines += section.lines.size();
  return lines;
}

std::vector<std::span<const Section>> cut(std::span<const Section> sections, std::size_t piece) {
  std::vector<std::span<const Section>> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= sections.size(); ++i) {
    const bool full = i == sections.size() || length(sections.subspan(first, i + 1 - first)) > piece;
    if (!full) continue;
    pieces.push_back(sections.subspan(first, i - first));
    first = i;
  }
  return pieces;
}

// Names that a piece makes, and those that it uses and does not make.
struct Names {
  std::set<std::string> made, taken;
};

Names names_of(std::span<const Section> piece) {
  Names names;
  for (const Section& section : piece) names.made.insert(section.defines.begin(), section.defines.end());
  for (const Section& section : piece)
    for (const std::string& name : section.uses)
      if (names.made.count(name) == 0) names.taken.insert(name);
  return names;
}

std::string listed(const std::string& front, const std::set<std::string>& names, const std::string& separator,
                   const std::string& back) {
  std::string text = front;
  for (const std::string& name : names) text += (&name == &*names.begin() ? "" : separator) + name;
  std::string result;
  for (const std::string& line : wrapped(text + back, "      ")) result += line + "\n";
  return names.empty() ? "" : result;
}

std::string split(const program::Program& program, const Shape& shape,
                  const std::vector<std::span<const Section>>& pieces, const Syntax& syntax) {
  const std::string space = shape.name + "_pieces", real = syntax.scalar();
  const Syntax inner = syntax.within(space);
  std::vector<Names> names;
  std::set<std::string> crossing;
  for (const auto& piece : pieces) {
    names.push_back(names_of(piece));
    crossing.insert(names.back().taken.begin(), names.back().taken.end());
  }
  const std::string none = crossing.empty() && shape.angles.empty() && syntax.is_c() ? "  char none;\n" : "";
  std::string text = syntax.open(space) + (syntax.is_c() ? "" : "\n") +
                     "// results that one piece makes and another uses\n" + inner.open_struct("Shared") +
                     listed("  " + real + " ", crossing, ", ", ";") + shape.angles.declarations(syntax, "  ") + none +
                     inner.close_struct("Shared");
  std::string calls;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::string name = "piece_" + std::to_string(i + 1);
    const std::string local = shape.out_local.empty() ? "" : ", " + syntax.maybe_unused(real + "* " + shape.out_local);
    std::vector<std::string> unused = shape.piece_unused;
    if (!local.empty()) unused.push_back(shape.out_local);
    unused.push_back("shared");
    text += "\n" +
            inner.opening("void", name,
                          shape.piece_parameters + local + ", " +
                              syntax.maybe_unused(syntax.written(inner.type("Shared"), "shared")),
                          unused, true) +
            shape.usings;
    if (!shape.angles.empty())
      text += "  " +
              syntax.maybe_unused("const " + real + " *const cosines = " + syntax.member("shared", "cosines") +
                                  ", *const sines = " + syntax.member("shared", "sines") + ";\n") +
              syntax.unused({"cosines", "sines"});
    for (const std::string& taken : names[i].taken)
      text += "  const " + real + " " + taken + " = " + syntax.member("shared", taken) + ";\n";
    text += body(program, pieces[i], syntax);
    for (const std::string& made : names[i].made)
      if (crossing.count(made) > 0) text += "  " + syntax.member("shared", made) + " = " + made + ";\n";
    text += "}\n";
    calls += "  " + syntax.from_outside(space, name) + "(" + shape.arguments +
             (local.empty() ? "" : ", " + shape.out_local) + ", " + (syntax.is_c() ? "&shared" : "shared") + ");\n";
  }
  text += "\n" + syntax.close(space) + (syntax.is_c() ? "" : "\n");
  return text + syntax.opening("void", shape.name, shape.parameters, shape.unused) + shape.begin + "  " +
         syntax.from_outside(space, syntax.is_c() ? "Shared" : "Shared<T>") + " shared;\n" +
         shape.angles.calls(syntax, "shared.") + calls + shape.end + "}\n";
}

}  // namespace

std::string function_text(const program::Program& program, const Shape& shape, const std::vector<Section>& sections,
                          const Lengths& lengths, const Syntax& syntax) {
  if (length(sections) > lengths.whole) return split(program, shape, cut(sections, lengths.piece), syntax);
  return syntax.opening("void", shape.name, shape.parameters, shape.unused) + shape.usings + shape.begin +
         shape.angles.declarations(syntax, "  ") + shape.angles.calls(syntax, "") + body(program, sections, syntax) +
         shape.end + "}\n";
}

}  // namespace kanec::emit
