// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/function.hpp"

#include <algorithm>
#include <utility>

#include "generator/emit/calls.hpp"
#include "generator/emit/rolled.hpp"
#include "generator/emit/section.hpp"
#include "generator/emit/signature.hpp"
#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

using program::Function;
using program::Index;
using program::Quantity;
using program::Ref;
using program::Stage;

class Emission {
 public:
  Emission(const Model& model, const program::Program& program, const std::vector<Stage>& stages,
           const Function& function, const program::Ledger& cost, const Named& named)
      : model_(model),
        program_(program),
        stages_(stages),
        function_(function),
        results_(results(function)),
        syntax_(model),
        arguments_(program, function, named.has_inputs, syntax_),
        cost_(cost),
        named_(named),
        angles_(program, function, model.optimize),
        statements_(program, stages, Stage::state, function.outputs, function_scope(program, function, syntax_),
                    syntax_) {
    for (const auto& [node, name] : named.prepared) statements_.name(node, name);
    for (std::size_t i = 0; i < function.outputs.size(); ++i) places_[function.outputs[i].node].push_back(i);
    stored_.assign(function.outputs.size(), false);
    for (std::size_t i = 0; i < program.nodes.size(); ++i) {
      const auto* variable = std::get_if<program::Variable>(&program.nodes[i]);
      if (variable != nullptr && variable->group == program::Group::x && angles_.has(variable->index))
        statements_.take_turn(static_cast<Index>(i), "[" + std::to_string(variable->index) + "]");
    }
  }

  std::string text(const Form& form) {
    if (form.loops) return comments() + rolled_text(model_, program_, function_, *form.loops, named_);
    const bool placed = !function_.placements.empty();
    Shape shape{function_.name,
                arguments_.parameters(),
                arguments_.unused(),
                arguments_.piece_parameters(),
                arguments_.piece_unused(),
                arguments_.values("c", "u"),
                "",
                "",
                "",
                usings(program_, angles_.others(program_, reachable(program_, function_.outputs)), stages_,
                       Stage::state, syntax_),
                angles_};
    if (placed) {
      block_ = shape.out_local = "block";
      shape.begin = "  " + syntax_.scalar() + " block[" + std::to_string(function_.outputs.size()) + "];\n";
      shape.end = placements(results_[0].out);
    } else {
      shape.begin = zeros();
    }
    for (const Quantity& quantity : function_.quantities) add(quantity);
    end_section();
    store_rest();
    return comments() + function_text(program_, shape, sections_, model_.lengths, syntax_);
  }

 private:
  std::string comments() const {
    std::string text;
    const auto append = [&text](const std::string& comment) {
      for (const std::string& line : wrapped("// " + comment, "//   ")) text += line + "\n";
    };
    append(function_.name + ": " + function_.meaning + ".");
    for (const program::Result& result : results_)
      append((results_.size() > 1 ? result.out + ": " : "") + result.layout);
    append(program::text(cost_));
    if (!function_.choice.empty()) append("by: " + function_.choice);
    return text;
  }

  bool is_zero(Ref ref) const {
    const auto* constant = std::get_if<program::Constant>(&program_.nodes[static_cast<std::size_t>(ref.node)]);
    return constant != nullptr && constant->value == program::Number(0.0);
  }

  // Many zeros of a result are stored by one loop before anything else.
  std::string zeros() {
    std::string text;
    std::size_t first = 0;
    for (const program::Result& result : results_) {
      const std::size_t end = first + static_cast<std::size_t>(result.count);
      std::size_t count = 0;
      for (std::size_t i = first; i < end; ++i) count += is_zero(function_.outputs[i]);
      for (std::size_t i = first; i < end && count >= 8; ++i) stored_[i] = is_zero(function_.outputs[i]);
      if (count >= 8)
        text += "  for (int i = 0; i < " + std::to_string(result.count) + "; ++i) " + result.out +
                "[i] = " + syntax_.number("0") + ";\n";
      first = end;
    }
    return text;
  }

  // "xdot[3]", where output i goes.
  std::string place(std::size_t i) const {
    if (!block_.empty()) return block_ + "[" + std::to_string(i) + "]";
    auto at = static_cast<Index>(i);
    for (const program::Result& result : results_) {
      if (at < result.count) return result.out + "[" + std::to_string(at) + "]";
      at -= result.count;
    }
    throw InternalError("emit: an output of no result");
  }

  void add(const Quantity& quantity) {
    const std::pair section(quantity.pass, quantity.body);
    if (section != pass_and_body_) {
      end_section();
      pass_and_body_ = section;
      section_.heading = heading();
      const std::string letter = quantity.pass == program::Pass::outward  ? "t"
                                 : quantity.pass == program::Pass::inward ? "b"
                                                                          : "z";
      statements_.number_temporaries(letter + std::to_string(quantity.body) + "_");
    }
    for (std::size_t i = 0; i < quantity.entries.size(); ++i)
      statements_.define(quantity.labels[i], quantity.entries[i]);
    const std::vector<std::string> lines = statements_.take_lines();
    if (!lines.empty()) {
      const std::string meaning = quantity.meaning.empty() ? "" : ": " + quantity.meaning;
      append(wrapped("  // " + quantity.equation + meaning, "  //   "));
      append(lines);
    }
    for (const Ref entry : quantity.entries)
      if (statements_.has_name(entry)) store(entry.node);
  }

  // Stores all outputs that are this node or its negative.
  void store(Index node) {
    const auto places = places_.extract(node);  // once a node: zeros are many
    if (places.empty()) return;
    for (const std::size_t i : places.mapped()) {
      if (stored_[i]) continue;
      stored_[i] = true;
      const std::string value = statements_.value(function_.outputs[i]);
      statements_.line(place(i) + " = " + value + ";");
    }
    append(statements_.take_lines());
  }

  void store_rest() {
    constexpr std::size_t lines_a_section = 250;
    statements_.number_temporaries("t");
    if (!function_.quantities.empty()) section_.heading = "results";
    for (const Ref output : function_.outputs) {
      store(output.node);
      if (section_.lines.size() > lines_a_section) end_section();
    }
    end_section();
  }

  void append(const std::vector<std::string>& lines) {
    section_.lines.insert(section_.lines.end(), lines.begin(), lines.end());
  }

  void end_section() {
    section_.reads = statements_.take_variables();
    section_.defines = statements_.take_defined();
    section_.uses = statements_.take_used();
    if (!section_.lines.empty()) sections_.push_back(std::move(section_));
    section_ = {};
  }

  std::string heading() const {
    const auto [pass, k] = pass_and_body_;
    if (k == 0) return "whole system";
    const scene::Scene& scene = *model_.scene;
    const auto at = static_cast<std::size_t>(k - 1);
    const int lower = scene.lower[at];
    const std::string body = "body " + std::to_string(k) + " (" + scene.bodies[at].name + ")";
    if (pass == program::Pass::inward) return body + " and what it carries";
    if (pass == program::Pass::solved) return body + ", solved";
    return body + " on " + (lower == 0 ? "the inertial frame" : "body " + std::to_string(lower));
  }

  // The same block stands at many places: copied by a table.
  std::string placements(const std::string& out) const {
    std::string table =
        "\n  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere\n"
        "  " +
        syntax_.local_table("int") + " places[][2] = {\n";
    std::string row = "     ";
    for (const program::Placement& place : function_.placements)
      row += " {" + std::to_string(place.block) + "," + std::to_string(place.offset) + "},";
    for (const std::string& line : wrapped(row, "      ")) table += line + "\n";
    table += "  };\n  for (int i = 0; i < " + std::to_string(function_.n_out) + "; ++i) " + out +
             "[i] = " + syntax_.number("0") + ";\n";
    const std::string place = syntax_.is_c() ? "places[place]" : "place";
    table += syntax_.is_c()
                 ? "  for (int place = 0; place < " + std::to_string(function_.placements.size()) + "; ++place)\n"
                 : "  for (const auto& place : places)\n";
    table += "    for (int i = 0; i < 3; ++i)\n      for (int j = 0; j < 3; ++j) " + out + "[" + place + "[1] + i * " +
             std::to_string(function_.stride) + " + j] = block[9 * " + place + "[0] + 3 * i + j];\n";
    return table;
  }

  const Model& model_;
  const program::Program& program_;
  const std::vector<Stage>& stages_;
  const Function& function_;
  std::vector<program::Result> results_;
  Syntax syntax_;
  ArgumentList arguments_;
  program::Ledger cost_;
  const Named& named_;
  Angles angles_;
  Statements statements_;
  std::unordered_map<Index, std::vector<std::size_t>> places_;  // outputs by node
  std::vector<bool> stored_;
  std::pair<program::Pass, int> pass_and_body_{program::Pass::outward, -1};
  Section section_;
  std::vector<Section> sections_;
  std::string block_;  // the local array of a function with placements
};

}  // namespace

std::string prepared_name(const program::Program& program, const Named& named, Index node, const Syntax& syntax) {
  const auto known = named.prepared.find(node);
  if (known != named.prepared.end()) return known->second.text;
  const auto* variable = std::get_if<program::Variable>(&program.nodes[static_cast<std::size_t>(node)]);
  if (variable == nullptr) throw InternalError("emit: a result of parameters without a name");
  return variable_name(program, *variable, Stage::state, syntax);
}

std::string emit_function(const Model& model, const program::Program& program, const std::vector<Stage>& stages,
                          const Function& function, const program::Ledger& cost, const Named& named, const Form& form) {
  return Emission(model, program, stages, function, cost, named).text(form);
}

}  // namespace kanec::emit
