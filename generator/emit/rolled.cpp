// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/rolled.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "generator/emit/section_text.hpp"
#include "generator/emit/signature.hpp"
#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

using program::Index;
using program::Rolled;

std::string indented_block(const std::string& text, const std::string& indent) {
  std::string result;
  for (const std::string& line : wrapped(text, indent)) result += line + "\n";
  return result;
}

// A run of steps of one kind, on ascending rows.
struct Run {
  std::size_t of, first, count;
};

std::vector<Run> runs(const Rolled& rolled) {
  std::vector<Run> result;
  for (const program::Step& step : rolled.steps)
    if (!result.empty() && result.back().of == step.of)
      ++result.back().count;
    else
      result.push_back({step.of, step.member, 1});
  return result;
}

std::vector<std::string> field_names(const Rolled& rolled) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const program::Stem& field : rolled.fields) {
    std::string name = field.with("");
    if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name = "s" + name;
    for (int i = 2; !taken.insert(name).second; ++i) name = field.with("") + "_" + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

class Loops {
 public:
  Loops(const Model& model, const program::Program& program, const program::Function& function, const Rolled& rolled,
        const Named& named)
      : syntax_(model),
        inner_(syntax_.within(function.name + "_sections")),
        arguments_(program, function, named.has_inputs, syntax_),
        function_(function),
        rolled_(rolled),
        scope_{&model,
               &program,
               &function,
               &rolled,
               &named,
               syntax_,
               inner_,
               field_names(rolled),
               Angles(program, function, model.optimize)} {}

  std::string text() {
    std::map<std::string, int> numbers;
    std::string tables, functions;
    for (const program::SectionClass& kind : rolled_.classes) {
      const int number = ++numbers[section_name(kind, 0)];
      const SectionText made = section_text(scope_, kind, number, gathered_);
      calls_.push_back(inner_.global(made.name) + "(" + made.arguments + ");");
      tables += made.tables;
      functions += "\n" + made.function;
    }
    const std::string space = function_.name + "_sections";
    const std::string own = frame_text() + number_text() + tables + functions + "\n";
    if (syntax_.is_c()) return own + main_text(space);
    return syntax_.open(space) + "\n" + own + syntax_.close(space) + "\n" + main_text(space);
  }

 private:
  // Places in a body's frame of what other sections read.
  std::string frame_text() const {
    const Syntax frame = inner_.within("frame");
    std::string list;
    for (std::size_t i = 0; i < scope_.fields.size(); ++i)
      list += (i == 0 ? "" : ", ") + frame.global(scope_.fields[i]) + " = " + std::to_string(rolled_.slots[i]);
    if (list.empty()) return "";
    return "// Results of a body's sections that others read, by their place in the body's frame; fields that no body "
           "has both\n"
           "// of may share one. K, L and J in tables: where the frames of a body, of its lower and of an upper one "
           "begin.\n" +
           syntax_.open("frame") + frame.constants(list) + syntax_.close("frame") + "\n";
  }

  std::string number_text() const {
    if (syntax_.is_c()) return "";
    return "// how constants stand in tables\ntemplate <class T>\nstruct Constants {\n  using Number = double;\n};\n"
           "template <>\nstruct Constants<float> {\n  using Number = float;\n};\n"
           "template <class T>\nusing Number = typename Constants<T>::Number;\n\n";
  }

  // Inputs or results of parameters as an array that tables can point into.
  std::string array(const std::string& name, const std::vector<std::string>& entries) const {
    if (entries.empty()) return "";
    std::string list;
    for (const std::string& entry : entries) list += (list.empty() ? "" : ", ") + entry;
    return indented_block("  const " + syntax_.scalar() + " " + name + "[] = {" + list + "};", "      ");
  }

  static std::vector<Index> in_place(const std::map<Index, Index>& places) {
    std::vector<Index> result(places.size());
    for (const auto& [what, place] : places) result[static_cast<std::size_t>(place)] = what;
    return result;
  }

  std::string arrays() const {
    std::vector<std::string> inputs, prepared;
    for (const Index i : in_place(gathered_.inputs))
      inputs.push_back(variable_name(*scope_.program, {program::Group::input, i}, program::Stage::state, syntax_));
    for (const Index node : in_place(gathered_.prepared))
      prepared.push_back(prepared_name(*scope_.program, *scope_.named, node, syntax_));
    return array("inputs", inputs) + array("prepared", prepared);
  }

  std::string main_text(const std::string& space) const {
    std::string text = syntax_.opening("void", function_.name, arguments_.parameters(), arguments_.unused());
    if (!syntax_.is_c()) text += "  using namespace " + space + ";\n";
    text += "  " +
            syntax_.maybe_unused(syntax_.scalar() + " frames[" + std::to_string(std::max(rolled_.frames_size, 1)) +
                                 "];\n") +
            syntax_.unused({"frames"}) + arrays() + scope_.angles.declarations(syntax_, "  ") +
            scope_.angles.calls(syntax_, "");
    const std::vector<Run> all = runs(rolled_);
    constexpr std::size_t most_loops = 12;
    return text + (all.size() <= most_loops ? loops(all) : steps()) + "}\n";
  }

  std::string loops(const std::vector<Run>& all) const {
    std::string text;
    for (const Run& run : all) {
      const std::string end = std::to_string(run.first + run.count);
      const bool has_rows = rolled_.classes[run.of].bodies.size() > 1;
      if (has_rows) text += "  for (int row = " + std::to_string(run.first) + "; row < " + end + "; ++row)\n";
      text += indented_block((has_rows ? "    " : "  ") + calls_[run.of], "        ");
    }
    return text;
  }

  std::string steps() const {
    std::size_t largest = 0;
    std::string list;
    for (const program::Step& step : rolled_.steps) {
      largest = std::max({largest, step.of, step.member});
      list += (list.empty() ? "{" : ", {") + std::to_string(step.of) + "," + std::to_string(step.member) + "}";
    }
    std::string text = "  // kind of section, and row of its tables\n  " +
                       syntax_.local_table(largest < 256 ? "unsigned char" : "unsigned short") + " steps[][2] = {\n";
    text += indented_block("      " + list + "};", "      ");
    const std::string step = syntax_.is_c() ? "steps[step]" : "step";
    text += syntax_.is_c() ? "  for (int step = 0; step < " + std::to_string(rolled_.steps.size()) + "; ++step) {\n"
                           : "  for (const auto& step : steps) {\n";
    text += "    " + syntax_.maybe_unused("const int row = " + step + "[1];\n") + syntax_.unused({"row"}, "    ") +
            "    switch (" + step + "[0]) {\n";
    for (std::size_t c = 0; c < calls_.size(); ++c)
      text += indented_block("      case " + std::to_string(c) + ": " + calls_[c] + " break;", "          ");
    return text + "    }\n  }\n";
  }

  Syntax syntax_, inner_;  // of the model, and of what this function is made of
  ArgumentList arguments_;
  const program::Function& function_;
  const Rolled& rolled_;
  RolledScope scope_;
  Gathered gathered_;
  std::vector<std::string> calls_;  // of the kinds of section
};

}  // namespace

std::string rolled_text(const Model& model, const program::Program& program, const program::Function& function,
                        const Rolled& rolled, const Named& named) {
  return Loops(model, program, function, rolled, named).text();
}

}  // namespace kanec::emit
