// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/function.hpp"

#include <algorithm>
#include <utility>

#include "generator/emit/section.hpp"
#include "generator/emit/signature.hpp"

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
           const Function& function, const program::Ledger& cost, const PreparedNames& prepared)
      : model_(model),
        program_(program),
        function_(function),
        cost_(cost),
        statements_(program, stages, Stage::state, function.outputs) {
    for (const auto& [node, name] : prepared) statements_.name(node, name);
    for (std::size_t i = 0; i < function.outputs.size(); ++i) places_[function.outputs[i].node].push_back(i);
    stored_.assign(function.outputs.size(), false);
  }

  std::string text() {
    const Signature& signature = function_.signature;
    const bool placed = !function_.placements.empty();
    Shape shape{function_.name, parameter_list(signature, reads()), parameter_list(signature, {}), argument_list(signature, "c", "u", signature.out),
                "", "", "", usings()};
    if (placed) {
      out_ = shape.out_local = "block";
      shape.begin = "  T block[" + std::to_string(function_.outputs.size()) + "];\n";
      shape.end = placements(signature.out);
    } else {
      out_ = signature.out;
      shape.begin = zeros();
    }
    for (const Quantity& quantity : function_.quantities) add(quantity);
    end_section();
    store_rest();
    return "// " + function_.name + ": " + function_.meaning + ".\n// " + signature.layout + "\n// " +
           program::text(cost_) + "\n" + function_text(program_, shape, sections_);
  }

 private:
  std::string usings() const {
    return std::string(cost_.square_roots > 0 ? "  using std::sqrt;\n" : "") +
           (cost_.trigonometric > 0 ? "  using std::cos, std::sin;\n" : "");
  }

  Reads reads() const {
    Reads reads;
    for (std::size_t i = 0; i < program_.nodes.size(); ++i) {
      if (!statements_.needs({static_cast<Index>(i), false})) continue;
      if (const auto* variable = std::get_if<program::Variable>(&program_.nodes[i])) {
        reads.prepared |= variable->group == program::Group::parameter;
        reads.x |= variable->group == program::Group::x;
        reads.y |= variable->group == program::Group::y;
        reads.ydot |= variable->group == program::Group::ydot;
        reads.inputs |= variable->group == program::Group::input;
      }
    }
    return reads;
  }

  bool is_zero(Ref ref) const {
    const auto* constant = std::get_if<program::Constant>(&program_.nodes[static_cast<std::size_t>(ref.node)]);
    return constant != nullptr && constant->value == program::Number(0.0);
  }

  // Many zeros are stored by one loop before anything else.
  std::string zeros() {
    const auto count =
        std::count_if(function_.outputs.begin(), function_.outputs.end(), [this](Ref ref) { return is_zero(ref); });
    if (count < 8) return "";
    for (std::size_t i = 0; i < stored_.size(); ++i) stored_[i] = is_zero(function_.outputs[i]);
    return "  for (int i = 0; i < " + std::to_string(function_.outputs.size()) + "; ++i) " + out_ + "[i] = T(0);\n";
  }

  void add(const Quantity& quantity) {
    const std::pair place(quantity.pass, quantity.body);
    if (place != place_) {
      end_section();
      place_ = place;
      section_.heading = heading();
      const std::string letter = quantity.pass == program::Pass::outward ? "t" : "b";
      statements_.number_temporaries(letter + std::to_string(quantity.body) + "_");
    }
    for (std::size_t i = 0; i < quantity.entries.size(); ++i) statements_.define(quantity.labels[i], quantity.entries[i]);
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
      statements_.line(out_ + "[" + std::to_string(i) + "] = " + value + ";");
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
    const auto [pass, k] = place_;
    if (k == 0) return "whole system";
    const scene::Scene& scene = *model_.scene;
    const auto at = static_cast<std::size_t>(k - 1);
    const int lower = scene.lower[at];
    const std::string body = "body " + std::to_string(k) + " (" + scene.bodies[at].name + ")";
    if (pass == program::Pass::inward) return body + " and what it carries";
    return body + " on " + (lower == 0 ? "the inertial frame" : "body " + std::to_string(lower));
  }

  // The same block stands at many places: copied by a table.
  std::string placements(const std::string& out) const {
    std::string table = "\n  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere\n"
                        "  static constexpr int places[][2] = {\n";
    std::string row = "     ";
    for (const program::Placement& place : function_.placements)
      row += " {" + std::to_string(place.block) + "," + std::to_string(place.offset) + "},";
    for (const std::string& line : wrapped(row, "      ")) table += line + "\n";
    table += "  };\n  for (int i = 0; i < " + std::to_string(function_.n_out) + "; ++i) " + out + "[i] = T(0);\n";
    table += "  for (const auto& place : places)\n    for (int i = 0; i < 3; ++i)\n      for (int j = 0; j < 3; ++j) " + out +
             "[place[1] + i * " + std::to_string(function_.stride) + " + j] = block[9 * place[0] + 3 * i + j];\n";
    return table;
  }

  const Model& model_;
  const program::Program& program_;
  const Function& function_;
  program::Ledger cost_;
  Statements statements_;
  std::unordered_map<Index, std::vector<std::size_t>> places_;  // outputs by node
  std::vector<bool> stored_;
  std::pair<program::Pass, int> place_{program::Pass::outward, -1};
  Section section_;
  std::vector<Section> sections_;
  std::string out_;
};

}  // namespace

std::string emit_function(const Model& model, const program::Program& program, const std::vector<Stage>& stages,
                          const Function& function, const program::Ledger& cost, const PreparedNames& prepared) {
  return Emission(model, program, stages, function, cost, prepared).text();
}

}  // namespace kanec::emit
