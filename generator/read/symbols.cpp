// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/symbols.hpp"

#include <algorithm>
#include <array>

#include "generator/scene/spelling.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

constexpr auto name_rule =
    "a C++ identifier: letters, digits, single underscores, at most 63, a letter first, no keyword";

// Types and namespaces of the emitted code, and macros of C++ headers.
constexpr std::array reserved = {"kanec", "std",   "T",      "Parameters", "Inputs",   "Prepared", "NULL",
                                 "NAN",   "errno", "assert", "INFINITY",   "HUGE_VAL", "linux",    "unix"};

// Namespaces of kanec itself, beside which the one of a scene would stand.
constexpr std::array namespaces = {"scene",   "symbolic", "program", "lower", "emit",  "generic",       "integrate",
                                   "compile", "cli",      "detail",  "lanes", "Lanes", "kanec_cos_sin", "kanec_series"};

template <class List>
bool contains(const List& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Capitals alone, or M_ and a letter: by custom macros, and many that C headers define (M_PI, EOF, BUFSIZ, INT_MAX).
bool looks_like_macro(const std::string& name) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (name.size() > 2 && name.compare(0, 2, "M_") == 0 && is_capital(name[2])) return true;
  return name.size() > 2 && std::all_of(name.begin(), name.end(), [&](char c) { return is_capital(c) || c == '_'; });
}

void check_name(const std::string& name, const Place& place) {
  if (!is_identifier(name)) fail(place, in_quotes(name), name_rule);
  if (contains(reserved, name)) fail(place, in_quotes(name) + ", which the emitted code uses itself", "another name");
  if (is_spelling(name))
    fail(place, in_quotes(name) + ", which is how emitted code spells " + in_quotes(name.substr(0, name.size() - 1)),
         "another name");
  if (looks_like_macro(name))
    fail(place, in_quotes(name) + ", which may be a macro in C headers", "a name with small letters");
}

template <class List>
std::optional<int> index_of(const List& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.named.name == name; });
  if (found == list.end()) return std::nullopt;
  return static_cast<int>(found - list.begin());
}

}  // namespace

std::string read_name(const Node& node) {
  std::string name = node.text(name_rule);
  check_name(name, node.place());
  return name;
}

std::string read_scene_name(const Node& node) {
  std::string name = read_name(node);
  if (contains(namespaces, name)) fail(node.place(), in_quotes(name) + ", a namespace of kanec", "another name");
  return name;
}

void Symbols::add_parameters(const Table& table) { add(parameters_, table); }
void Symbols::add_inputs(const Table& table) { add(inputs_, table); }

void Symbols::add(std::vector<Symbol>& list, const Table& table) {
  for (const auto& [name, node] : table.entries()) {
    check_name(name, node.place());
    const auto& other = &list == &inputs_ ? parameters_ : inputs_;
    if (const auto twin = index_of(other, name))
      fail(node.place(),
           "a parameter and an input of this name, the other on line " +
               std::to_string(other[static_cast<std::size_t>(*twin)].place.line),
           "two names");
    list.push_back({{name, node.real("a finite number, the default")}, node.place()});
  }
}

std::optional<Number> Symbols::find(const std::string& name) {
  if (const auto index = index_of(parameters_, name)) {
    parameters_[static_cast<std::size_t>(*index)].used = true;
    return Number::parameter(*index);
  }
  const auto index = index_of(inputs_, name);
  if (!index) return std::nullopt;
  inputs_[static_cast<std::size_t>(*index)].used = true;
  return Number::input(*index);
}

Number Symbols::constant_or_parameter(const Node& node) {
  if (!node.is_text()) return Number::constant(node.real("a finite number, or the name of a parameter"));
  const std::string name = node.text("");
  const std::optional<Number> found = find(name);
  if (found && found->kind == Number::Kind::parameter) return *found;
  if (found) fail(node.place(), "the input " + name, "a number or a parameter: inputs are for loads alone");
  std::vector<std::string> known;
  for (const Symbol& symbol : parameters_) known.push_back(symbol.named.name);
  const std::string names = known.empty() ? " (this scene has none)" : ": " + one_of(known, name);
  fail(node.place(), "the text " + in_quotes(name), "a number or the name of a parameter" + names);
}

Vector Symbols::vector(const Node& node) {
  Vector out;
  const std::vector<Node> list = node.list(3, "a list of 3 numbers or names");
  for (std::size_t i = 0; i < 3; ++i) out[i] = constant_or_parameter(list[i]);
  return out;
}

double Symbols::value(const Number& number) const {
  if (number.kind == Number::Kind::constant) return number.value;
  const auto& list = number.kind == Number::Kind::parameter ? parameters_ : inputs_;
  return list[static_cast<std::size_t>(number.index)].named.value;
}

std::string Symbols::shown(const Number& number) const {
  if (number.kind == Number::Kind::constant) return shortest(number.value);
  const auto& list = number.kind == Number::Kind::parameter ? parameters_ : inputs_;
  const Named& named = list[static_cast<std::size_t>(number.index)].named;
  return named.name + " = " + shortest(named.value);
}

void Symbols::mark_used(const Expression& expression) {
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind == ExpressionNode::Kind::parameter) parameters_[static_cast<std::size_t>(node.index)].used = true;
    if (node.kind == ExpressionNode::Kind::input) inputs_[static_cast<std::size_t>(node.index)].used = true;
  }
}

void Symbols::refuse(const std::map<std::string, std::string>& taken) const {
  for (const auto* list : {&parameters_, &inputs_})
    for (const Symbol& symbol : *list)
      if (const auto found = taken.find(symbol.named.name); found != taken.end())
        fail(symbol.place, in_quotes(symbol.named.name) + ", which is " + found->second, "another name");
}

std::vector<std::string> Symbols::warnings() const {
  std::vector<std::string> out;
  for (const auto* list : {&parameters_, &inputs_})
    for (const Symbol& symbol : *list)
      if (!symbol.used) out.push_back(remark(symbol.place, "nothing in the scene uses it"));
  return out;
}

std::vector<Named> Symbols::named(const std::vector<Symbol>& list) {
  std::vector<Named> out;
  for (const Symbol& symbol : list) out.push_back(symbol.named);
  return out;
}

}  // namespace kanec::scene
