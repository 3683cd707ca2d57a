// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/section_text.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "generator/emit/calls.hpp"
#include "generator/emit/columns.hpp"
#include "generator/emit/letters.hpp"
#include "generator/emit/statements.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

using program::at;
using program::Index;
using program::Leaf;
using program::LeafKind;
using program::Ref;
using program::SectionClass;
using program::Stage;

std::string count(std::size_t n) { return std::to_string(n); }

bool are_equal(const std::vector<Index>& list) { return std::equal(list.begin() + 1, list.end(), list.begin()); }

// "unsigned char", the smallest type that holds the largest of them.
std::string type_for(std::size_t largest) {
  return largest < 256 ? "unsigned char" : largest < 65536 ? "unsigned short" : "int";
}

std::string block_text(const std::string& text, const std::string& indent) {
  std::string result;
  for (const std::string& line : wrapped(text, indent)) result += line + "\n";
  return result;
}

class Text {
 public:
  Text(const RolledScope& scope, const SectionClass& kind, int number, Gathered& gathered)
      : scope_(scope), kind_(kind), gathered_(gathered), body_(kind.body) {
    result_.name = section_name(kind, number);
    for (const char* name : {"T", "c", "t", "x", "y", "ydot", "u", "inputs", "prepared", "frames", "row", "k", "own",
                             "frame", "cosines", "sines", "select", "Number"})
      names_.reserve(name);
    names_.reserve(syntax().scalar());
    for (const program::Result& made : results(*scope.function)) names_.reserve(made.out);
    for (const std::string& function : functions_called(*scope.program)) names_.reserve(function);
    for (const Index k : kind.bodies) own_.push_back(std::max(k, 0));
    find_frames();
    list_places();
  }

  SectionText result() {
    name_leaves();
    const std::string statements = make_statements();
    const std::string columns = columns_text();
    result_.function = heading() + opening() + using_text() + columns + frames_text_ + loads_ + statements + "}\n";
    add_tables();
    return std::move(result_);
  }

 private:
  const program::Program& program() const { return *scope_.program; }
  const Syntax& syntax() const { return scope_.syntax; }
  std::string real() const { return syntax().scalar(); }

  // Letters of the bodies whose results are read, K for the body itself; of a single body, their numbers.
  void find_frames() {
    if (own_.size() == 1) return number_frames();
    letter_of_[own_] = "K";
    std::vector<Index> lower;
    for (const Index k : own_) lower.push_back(k > 0 ? scope_.model->scene->lower[at(k) - 1] : -1);
    std::set<std::vector<Index>> others;
    std::vector<std::vector<Index>> in_order;
    for (const Leaf& leaf : kind_.leaves)
      if (leaf.kind == LeafKind::frame && leaf.places != own_ && others.insert(leaf.places).second)
        in_order.push_back(leaf.places);
    const std::size_t upper = in_order.size() - others.count(lower);
    int next = 0;
    for (const auto& places : in_order)
      letter_of_[places] = places == lower ? "L" : upper > 1 ? "J" + std::to_string(++next) : "J";
    letters_[lower[0]] = "L";
    for (const auto& [places, letter] : letter_of_) letters_[places[0]] = letter;
    letters_[own_[0]] = "K";
    letters_.erase(0);
    letters_.erase(-1);
  }

  void number_frames() {
    letter_of_[own_] = std::to_string(own_[0]);
    for (const Leaf& leaf : kind_.leaves)
      if (leaf.kind == LeafKind::frame) letter_of_[leaf.places] = std::to_string(leaf.places[0]);
  }

  void list_places() {
    for (const Leaf& leaf : kind_.leaves) {
      if (leaf.kind == LeafKind::input && !are_equal(leaf.places)) columns_.add("u", gathered(leaf, gathered_.inputs));
      if (leaf.kind == LeafKind::prepared && !are_equal(leaf.places))
        columns_.add("c", gathered(leaf, gathered_.prepared));
      if (is_state(leaf.kind)) columns_.add(array(leaf.kind), leaf.places);
      if (leaf.kind == LeafKind::frame && !are_equal(leaf.fields)) columns_.add("s", slots(leaf));
    }
    for (const program::Output& output : kind_.outputs) columns_.add(place(output).first, place(output).second);
  }

  static bool is_state(LeafKind kind) { return kind == LeafKind::x || kind == LeafKind::y || kind == LeafKind::ydot; }

  static std::string array(LeafKind kind) { return kind == LeafKind::x ? "x" : kind == LeafKind::y ? "y" : "ydot"; }

  // Places in an array of what stands at scattered places; a new one behind those before.
  static Columns::Places gathered(const Leaf& leaf, std::map<Index, Index>& known) {
    Columns::Places places;
    for (const Index i : leaf.places)
      places.push_back(known.emplace(i, static_cast<Index>(known.size())).first->second);
    return places;
  }

  // The result that an output belongs to, and its index there for every body.
  std::pair<std::string, Columns::Places> place(const program::Output& output) const {
    std::size_t before = 0;
    for (const program::Result& result : results(*scope_.function)) {
      if (output.places[0] < before + at(result.count)) {
        Columns::Places places;
        for (const std::size_t i : output.places) places.push_back(static_cast<Index>(i - before));
        return {result.out, places};
      }
      before += at(result.count);
    }
    throw InternalError("emit: an output of no result");
  }

  std::string frame(const std::vector<Index>& places) {
    parameters_.insert("frames");
    const std::string& letter = letter_of_.at(places);
    const std::string name = places == own_ ? "own" : "of_" + letter;
    if (framed_.insert(name).second) {
      names_.reserve(name);
      names_.reserve(letter);
      Columns::Places begins;
      for (const Index k : places) begins.push_back(scope_.rolled->begins[at(k)]);
      const std::string index = are_equal(places) ? std::to_string(begins[0]) : letter;
      if (!are_equal(places)) body_columns_.push_back({letter, begins});
      const std::string type = places == own_ ? real() + "* const " : "const " + real() + "* const ";
      frames_text_ += "  " + type + name + " = frames + " + index + ";\n";
    }
    return name;
  }

  Columns::Places slots(const Leaf& leaf) const {
    Columns::Places result;
    for (const Index field : leaf.fields) result.push_back(scope_.rolled->slots[at(field)]);
    return result;
  }

  std::string field(Index i) const { return scope_.inner.from_outside("frame", scope_.fields[at(i)]); }

  void load(std::size_t i, const std::string& name, const std::string& value) {
    body_.names.x[i] = names_.unique(name);
    loads_ += block_text("  const " + real() + " " + body_.names.x[i] + " = " + value + ";", "      ");
  }

  std::string variable(Index i, program::Group group) const {
    return lettered_name(variable_name(program(), {group, i}, Stage::state, syntax()), letters_);
  }

  // What the section reads, under the names that its statements use.
  void name_leaves() {
    body_.names.x.resize(kind_.leaves.size());
    for (std::size_t i = 0; i < kind_.leaves.size(); ++i) name_leaf(i, kind_.leaves[i]);
  }

  void name_leaf(std::size_t i, const Leaf& leaf) {
    switch (leaf.kind) {
      case LeafKind::constant:
        body_.names.x[i] = syntax().number("k[" + count(numbers_.size()) + "]");
        numbers_.push_back(&leaf.numbers);
        return;
      case LeafKind::x:
        return load_state(i, leaf, program::Group::x);
      case LeafKind::y:
        return load_state(i, leaf, program::Group::y);
      case LeafKind::ydot:
        return load_state(i, leaf, program::Group::ydot);
      case LeafKind::time:
        body_.names.x[i] = used("t");
        return;
      case LeafKind::input:
        return name_input(i, leaf);
      case LeafKind::prepared:
        return name_prepared(i, leaf);
      case LeafKind::frame:
        return load_frame(i, leaf);
    }
  }

  void load_state(std::size_t i, const Leaf& leaf, program::Group group) {
    if (is_angle(leaf) && !has_other_use(static_cast<Index>(i))) return;
    const std::string from = used(array(leaf.kind));
    load(i, variable(leaf.places[0], group), from + "[" + columns_.index(from, leaf.places) + "]");
  }

  bool is_angle(const Leaf& leaf) const { return leaf.kind == LeafKind::x && scope_.angles.has(leaf.places[0]); }

  // Whether anything but a cosine or a sine is taken of a leaf.
  bool has_other_use(Index leaf) const {
    for (const program::Node& node : body_.nodes) {
      const program::Operands from = operands(node);
      for (int i = 0; i < from.count && !is_turn(node); ++i) {
        const auto* variable = std::get_if<program::Variable>(&body_.nodes[at(from.at[i])]);
        if (variable != nullptr && variable->index == leaf) return true;
      }
    }
    const auto& outputs = body_.functions[0].outputs;
    return std::any_of(outputs.begin(), outputs.end(), [&](Ref output) {
      const auto* variable = std::get_if<program::Variable>(&body_.nodes[at(output.node)]);
      return variable != nullptr && variable->index == leaf;
    });
  }

  static bool is_turn(const program::Node& node) {
    return std::holds_alternative<program::Sine>(node) || std::holds_alternative<program::Cosine>(node);
  }

  // The leaf that a node of the body is, where that is an angle; else null.
  const Leaf* angle(Index node) const {
    const auto* variable = std::get_if<program::Variable>(&body_.nodes[at(node)]);
    if (variable == nullptr || !is_angle(kind_.leaves[at(variable->index)])) return nullptr;
    return &kind_.leaves[at(variable->index)];
  }

  // Cosines and sines of angles are in arrays of the function.
  void take_turns(Statements& statements) {
    for (const program::Node& node : body_.nodes) {
      const Leaf* leaf = is_turn(node) ? angle(operands(node).at[0]) : nullptr;
      if (leaf == nullptr) continue;
      used(std::holds_alternative<program::Cosine>(node) ? "cosines" : "sines");
      statements.take_turn(operands(node).at[0], "[" + columns_.index("x", leaf->places) + "]");
    }
  }

  void name_input(std::size_t i, const Leaf& leaf) {
    if (are_equal(leaf.places))
      body_.names.x[i] = syntax().member(used("u"), scene::spelled(program().names.inputs[at(leaf.places[0])]));
    else
      load(i, lettered_name(scene::spelled(program().names.inputs[at(leaf.places[0])]), letters_),
           used("inputs") + "[" + columns_.index("u", gathered(leaf, gathered_.inputs)) + "]");
  }

  void name_prepared(std::size_t i, const Leaf& leaf) {
    const std::string name = prepared_name(program(), *scope_.named, leaf.places[0], syntax());
    if (are_equal(leaf.places))
      body_.names.x[i] = used("c") + name.substr(1);
    else
      load(i, lettered_name(name.substr(name.find_last_of(".>") + 1), letters_),
           used("prepared") + "[" + columns_.index("c", gathered(leaf, gathered_.prepared)) + "]");
  }

  void load_frame(std::size_t i, const Leaf& leaf) {
    const std::string from = frame(leaf.places);
    const program::Stem& stem = scope_.rolled->fields[at(leaf.fields[0])];
    const std::string index = are_equal(leaf.fields) ? field(leaf.fields[0]) : columns_.index("s", slots(leaf));
    load(i, stem.with(letter_of_.at(leaf.places)), from + "[" + index + "]");
  }

  std::string make_statements() {
    const program::Function& function = body_.functions[0];
    const std::vector<Stage> stages = program::stages(body_);
    Statements statements(body_, stages, Stage::state, function.outputs, names_, syntax());
    const char* letter = kind_.pass == program::Pass::outward ? "t" : kind_.pass == program::Pass::inward ? "b" : "z";
    take_turns(statements);
    statements.number_temporaries(letter + (own_[0] > 0 ? letter_of_.at(own_) : "") + "_");
    std::string text;
    std::size_t entry = 0;
    for (const program::Quantity& quantity : function.quantities) {
      for (const Ref ref : quantity.entries) statements.define(kind_.names[entry++].with(letter_of_.at(own_)), ref);
      const std::string meaning = quantity.meaning.empty() ? "" : ": " + quantity.meaning;
      text += lines(statements, "  // " + lettered_equation(quantity.equation, letters_) + meaning);
    }
    return text + stores(statements);
  }

  // What was appended, with a comment before it.
  static std::string lines(Statements& statements, const std::string& comment) {
    const std::vector<std::string> made = statements.take_lines();
    std::string text = made.empty() || comment.empty() ? "" : block_text(comment, "  //   ");
    for (const std::string& line : made) text += line + "\n";
    return text;
  }

  // Last, so that nothing is read again for fear that it was overwritten.
  std::string stores(Statements& statements) {
    for (const program::Output& output : kind_.outputs) {
      const auto [out, places] = place(output);
      const std::string value = statements.value(output.value);
      statements.line(used(out) + "[" + columns_.index(out, places) + "] = " + value + ";");
    }
    for (const program::Kept& kept : kind_.kept) {
      const std::string value = statements.value(kept.value);
      statements.line(frame(own_) + "[" + field(kept.field) + "] = " + value + ";");
    }
    return lines(statements, "");
  }

  std::string heading() const {
    std::string bodies;
    for (const Index k : kind_.bodies) bodies += (bodies.empty() ? "" : ", ") + std::to_string(k);
    const std::size_t n = kind_.bodies.size();
    if (kind_.bodies[0] < 0) return "// results\n";
    if (kind_.bodies[0] == 0) return "// whole system\n";
    return block_text("// " + std::string(n > 1 ? "bodies " : "body ") + bodies +
                          (kind_.pass == program::Pass::inward   ? " and what they carry"
                           : kind_.pass == program::Pass::solved ? ", solved"
                                                                 : ""),
                      "//   ");
  }

  std::string used(const std::string& parameter) {
    parameters_.insert(parameter);
    return parameter;
  }

  // All that a section may take; results are pointers to what is written.
  std::vector<std::pair<std::string, std::string>> possible_parameters() const {
    const std::string entries = "const " + real() + "* ", written = real() + "* ";
    std::vector<std::pair<std::string, std::string>> list = {{"c", syntax().given(syntax().type("Prepared"), "")},
                                                             {"t", real() + " "},
                                                             {"x", entries},
                                                             {"y", entries},
                                                             {"ydot", entries},
                                                             {"u", syntax().given(syntax().type("Inputs"), "")},
                                                             {"inputs", entries},
                                                             {"prepared", entries}};
    for (const program::Result& result : results(*scope_.function)) {
      std::erase_if(list, [&](const auto& argument) { return argument.first == result.out; });
      list.push_back({result.out, written});
    }
    list.push_back({"cosines", entries});
    list.push_back({"sines", entries});
    list.push_back({"frames", written});
    list.push_back({"row", "int "});
    return list;
  }

  std::string opening() {
    std::string parameters;
    for (const auto& [name, type] : possible_parameters()) {
      if (parameters_.count(name) == 0) continue;
      parameters += (parameters.empty() ? "" : ", ") + type + name;
      result_.arguments += (result_.arguments.empty() ? "" : ", ") + name;
    }
    return scope_.inner.opening("void", result_.name, parameters, {}, true);
  }

  std::string using_text() const {
    const std::vector<Stage> stages = program::stages(body_);
    std::vector<bool> wanted = reachable(body_, body_.functions[0].outputs);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (is_turn(body_.nodes[i]) && angle(operands(body_.nodes[i]).at[0]) != nullptr) wanted[i] = false;
    return usings(body_, wanted, stages, Stage::state, syntax());
  }

  std::vector<std::pair<std::string, Columns::Places>> all_columns() const {
    auto all = body_columns_;
    all.insert(all.end(), columns_.all().begin(), columns_.all().end());
    return all;
  }

  std::string columns_text() {
    if (!numbers_.empty() || !all_columns().empty()) parameters_.insert("row");
    std::string names;
    const std::string places_table = scope_.inner.global(result_.name + "_places") + "[row]";
    const std::string numbers_table = scope_.inner.global(result_.name + "_numbers");
    std::size_t column = 0;
    for (const auto& [name, places] : all_columns()) {
      names += (names.empty() ? "" : ", ") + name;
      if (syntax().is_c()) names += " = " + places_table + "[" + count(column++) + "]";
    }
    std::string text;
    if (!names.empty())
      text = block_text(
          syntax().is_c() ? "  const int " + names + ";" : "  const auto& [" + names + "] = " + places_table + ";",
          "      ");
    if (!numbers_.empty())
      text += syntax().is_c() ? "  const kanec_real* const k = " + numbers_table + "[row];\n"
                              : "  const auto& k = " + numbers_table + "<Number<T>>[row];\n";
    return text;
  }

  void add_tables() {
    const auto columns = all_columns();
    const std::size_t n = kind_.bodies.size();
    if (!columns.empty()) {
      Index largest = 0;
      std::string names;
      for (const auto& [name, places] : columns) {
        largest = std::max(largest, *std::max_element(places.begin(), places.end()));
        names += (names.empty() ? "" : ", ") + name;
      }
      const std::string table = scope_.inner.table(type_for(at(largest)), result_.name + "_places",
                                                   "[" + count(n) + "][" + count(columns.size()) + "]");
      const std::string line = table + "{  // " + names + "\n";
      result_.tables += wrapped(line, "").size() == 1 ? line : block_text("// " + names, "// ") + table + "{\n";
      for (std::size_t m = 0; m < n; ++m)
        result_.tables += row([&](std::size_t j) { return std::to_string(columns[j].second[m]); }, columns.size());
      result_.tables += "};\n";
    }
    if (numbers_.empty()) return;
    const std::string number = syntax().is_c() ? real() : "C";
    result_.tables +=
        (syntax().is_c() ? "" : "template <class C>\n") +
        scope_.inner.table(number, result_.name + "_numbers", "[" + count(n) + "][" + count(numbers_.size()) + "]") +
        "{\n";
    for (std::size_t m = 0; m < n; ++m)
      result_.tables += row(
          [&](std::size_t j) {
            const std::string value = literal((*numbers_[j])[m].rounded());
            return syntax().is_c() ? syntax().number(value) : "C(" + value + ")";
          },
          numbers_.size());
    result_.tables += "};\n";
  }

  template <class Entry>
  static std::string row(const Entry& entry, std::size_t n) {
    std::string text;
    for (std::size_t j = 0; j < n; ++j) text += (j == 0 ? "" : ", ") + entry(j);
    return block_text("    {" + text + "},", "     ");
  }

  const RolledScope& scope_;
  const SectionClass& kind_;
  Gathered& gathered_;
  program::Program body_;
  std::vector<Index> own_;  // bodies, the whole system for what is no body's
  std::map<std::vector<Index>, std::string> letter_of_;
  Letters letters_;  // of the first body and its neighbours
  Columns columns_;
  std::vector<std::pair<std::string, Columns::Places>> body_columns_;
  std::vector<const std::vector<program::Number>*> numbers_;
  Scope names_;  // taken in the section
  std::set<std::string> framed_, parameters_;
  std::string frames_text_, loads_;
  SectionText result_;
};

}  // namespace

std::string section_name(const SectionClass& kind, int number) {
  if (kind.bodies[0] < 0) return "results";
  const std::string pass = kind.pass == program::Pass::outward  ? "outward"
                           : kind.pass == program::Pass::inward ? "inward"
                                                                : "solved";
  return pass + "_" + std::to_string(number);
}

SectionText section_text(const RolledScope& scope, const SectionClass& kind, int number, Gathered& gathered) {
  return Text(scope, kind, number, gathered).result();
}

}  // namespace kanec::emit
