// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/function.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "generator/emit/signature.hpp"

namespace kanec::emit {
namespace {

using program::Function;
using program::Group;
using program::Index;
using program::Quantity;
using program::Ref;
using program::Stage;

class Emission {
 public:
  Emission(const Model& model, const program::Program& program, const std::vector<Stage>& stages,
           const Function& function, const program::Ledger& cost, const PreparedNames& prepared)
      : model_(model), program_(program), function_(function), cost_(cost), statements_(program, stages, Stage::state, function.outputs) {
    for (const auto& [node, name] : prepared) statements_.name(node, name);
    for (std::size_t i = 0; i < function.outputs.size(); ++i) places_[function.outputs[i].node].push_back(i);
    stored_.assign(function.outputs.size(), false);
  }

  std::string text() {
    const Signature& shape = signature(function_.name);
    text_ = "// " + function_.name + ": " + function_.meaning + ".\n// " + shape.layout + "\n// " +
            program::text(cost_) + "\n";
    text_ += "template <class T>\n";
    for (const std::string& line : wrapped("void " + function_.name + "(" + parameter_list(shape) + ") noexcept {", "    "))
      text_ += line + "\n";
    use_functions();
    const bool placed = !function_.placements.empty();
    out_ = placed ? "block" : shape.out;
    if (placed)
      text_ += "  T block[" + std::to_string(function_.outputs.size()) + "];\n";
    else
      store_zeros();
    for (const Quantity& quantity : function_.quantities) add(quantity);
    end_section();
    store_rest();
    if (placed) text_ += placements(shape.out);
    return text_ + "}\n";
  }

 private:
  void use_functions() {
    if (cost_.square_roots > 0) text_ += "  using std::sqrt;\n";
    if (cost_.trigonometric > 0) text_ += "  using std::cos, std::sin;\n";
  }

  bool is_zero(Ref ref) const {
    const auto* constant = std::get_if<program::Constant>(&program_.nodes[static_cast<std::size_t>(ref.node)]);
    return constant != nullptr && constant->value == program::Number(0.0);
  }

  // Many zeros are stored by one loop before anything else.
  void store_zeros() {
    const auto zeros = std::count_if(function_.outputs.begin(), function_.outputs.end(), [this](Ref ref) { return is_zero(ref); });
    if (zeros < 8) return;
    text_ += "  for (int i = 0; i < " + std::to_string(function_.outputs.size()) + "; ++i) " + out_ + "[i] = T(0);\n";
    for (std::size_t i = 0; i < stored_.size(); ++i) stored_[i] = is_zero(function_.outputs[i]);
  }

  void add(const Quantity& quantity) {
    const std::pair section(quantity.pass, quantity.body);
    if (section != section_) {
      end_section();
      section_ = section;
      const std::string letter = quantity.pass == program::Pass::outward ? "t" : "b";
      statements_.number_temporaries(letter + std::to_string(quantity.body) + "_");
    }
    for (std::size_t i = 0; i < quantity.entries.size(); ++i) statements_.define(quantity.labels[i], quantity.entries[i]);
    std::vector<std::string> lines = statements_.take_lines();
    if (!lines.empty()) {
      const std::string meaning = quantity.meaning.empty() ? "" : ": " + quantity.meaning;
      for (const std::string& line : wrapped("  // " + quantity.equation + meaning, "  //   ")) body_.push_back(line);
      body_.insert(body_.end(), lines.begin(), lines.end());
    }
    for (const Ref entry : quantity.entries) store(entry.node);
  }

  // Stores outputs that are this node, once it has a name.
  void store(Index node) {
    const auto places = places_.find(node);
    if (places == places_.end() || !statements_.has_name({node, false})) return;
    for (const std::size_t i : places->second) store_at(i);
  }

  void store_at(std::size_t i) {
    if (stored_[i]) return;
    stored_[i] = true;
    const std::string value = statements_.value(function_.outputs[i]);
    std::vector<std::string> before = statements_.take_lines();
    body_.insert(body_.end(), before.begin(), before.end());
    statements_.line(out_ + "[" + std::to_string(i) + "] = " + value + ";");
    std::vector<std::string> lines = statements_.take_lines();
    body_.insert(body_.end(), lines.begin(), lines.end());
  }

  void store_rest() {
    statements_.number_temporaries("t");
    for (std::size_t i = 0; i < stored_.size(); ++i) store_at(i);
    section_ = {program::Pass::inward, 0};
    const bool any = !body_.empty();
    if (any && !function_.quantities.empty()) text_ += "\n";
    flush();
  }

  void end_section() {
    if (body_.empty()) return;
    text_ += "\n" + heading();
    flush();
  }

  void flush() {
    text_ += loads();
    for (const std::string& line : body_) text_ += line + "\n";
    body_.clear();
  }

  std::string heading() const {
    const auto [pass, k] = section_;
    if (k == 0) return "  // ---- whole system\n";
    const scene::Scene& scene = *model_.scene;
    const auto at = static_cast<std::size_t>(k - 1);
    const int lower = scene.lower[at];
    const std::string body = "body " + std::to_string(k) + " (" + scene.bodies[at].name + ")";
    if (pass == program::Pass::inward) return "  // ---- " + body + " and what it carries\n";
    return "  // ---- " + body + " on " + (lower == 0 ? "the inertial frame" : "body " + std::to_string(lower)) + "\n";
  }

  // Entries of the state read for the first time, a vector a line.
  std::string loads() {
    std::vector<program::Variable> read;
    for (const program::Variable& v : statements_.take_variables())
      if (v.group != Group::parameter && v.group != Group::input && loaded_.insert({v.group, v.index}).second)
        read.push_back(v);
    std::sort(read.begin(), read.end(),
              [](const auto& a, const auto& b) { return std::pair(a.group, a.index) < std::pair(b.group, b.index); });
    std::string result;
    std::string vector;
    for (const program::Variable& v : read) {
      const std::string name = variable_name(program_, v, Stage::state);
      const std::string stem = name.substr(0, name.rfind('_'));
      result += stem == vector ? ", " : (result.empty() ? "  const T " : ";\n  const T ");
      vector = stem;
      result += name + " = " + array(v.group) + "[" + std::to_string(v.index) + "]";
    }
    return result.empty() ? "" : result + ";\n";
  }

  static std::string array(Group group) { return group == Group::x ? "x" : group == Group::y ? "y" : "ydot"; }

  // The same block stands at many places: copied by a table.
  std::string placements(const std::string& out) const {
    std::string table = "\n  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere\n"
                        "  static constexpr int places[][2] = {";
    std::string line = "\n     ";
    for (const program::Placement& place : function_.placements) {
      const std::string item = " {" + std::to_string(place.block) + ", " + std::to_string(place.offset) + "},";
      if (line.size() + item.size() > 118) {
        table += line;
        line = "\n     ";
      }
      line += item;
    }
    table += line + "};\n";
    table += "  for (int i = 0; i < " + std::to_string(function_.n_out) + "; ++i) " + out + "[i] = T(0);\n";
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
  std::set<std::pair<Group, Index>> loaded_;
  std::pair<program::Pass, int> section_{program::Pass::outward, -1};
  std::vector<std::string> body_;
  std::string out_, text_;
};

}  // namespace

std::string emit_function(const Model& model, const program::Program& program, const std::vector<Stage>& stages,
                          const Function& function, const program::Ledger& cost, const PreparedNames& prepared) {
  return Emission(model, program, stages, function, cost, prepared).text();
}

}  // namespace kanec::emit
