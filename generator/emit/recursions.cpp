// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/recursions.hpp"

#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "generator/emit/calls.hpp"
#include "generator/emit/scope.hpp"
#include "generator/emit/statements.hpp"
#include "generator/emit/term.hpp"
#include "generator/program/overloaded.hpp"
#include "generator/program/series.hpp"
#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

using program::at;
using program::Group;
using program::Index;
using program::Recursion;
using program::Ref;
using program::Series;
using program::Stage;

// Labels of the function's quantities, the first that a result has; of its negative "minus_<label>".
std::unordered_map<Index, std::string> labels_of(const program::Function& function) {
  std::unordered_map<Index, std::string> result;
  for (const program::Quantity& quantity : function.quantities)
    for (std::size_t i = 0; i < quantity.entries.size(); ++i) {
      const Ref entry = quantity.entries[i];
      result.emplace(entry.node, (entry.negative ? "minus_" : "") + quantity.labels[i]);
    }
  return result;
}

// What stands around the statements: the arguments and members of the class, and names of the state.
Scope series_scope(const program::Program& program, const program::Function& function) {
  Scope scope = function_scope(program, function, Syntax());
  for (const char* name :
       {"z",        "zdot",      "k",     "n",    "now",    "v",     "f",      "s",    "F",
        "S",        "N",         "count", "size", "stride", "order", "values", "next", "coefficients",
        "products", "n_products"})
    scope.reserve(name);
  return scope;
}

// Names in the order of their numbers, as the entries of an enumeration.
class Rows {
 public:
  explicit Rows(std::string type) : type_(std::move(type)) {}

  int number(const std::string& name) {
    const auto [place, is_new] = numbers_.try_emplace(name, static_cast<int>(names_.size()));
    if (is_new) names_.push_back(name);
    return place->second;
  }
  // "F::omega1_1"
  std::string entry(const std::string& name) {
    number(name);
    return type_ + "::" + name;
  }
  std::string declaration(const std::string& meaning) const {
    std::string list = "  struct " + type_ + " { enum : int {";
    for (const std::string& name : names_) list += " " + name + ",";
    std::string text = "  // " + meaning + "\n";
    for (const std::string& line : wrapped(list + " count }; };", "    ")) text += line + "\n";
    return text;
  }

 private:
  std::string type_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> numbers_;
};

// The statements of both functions: the values, and coefficient k of everything.
class Recursions {
 public:
  Recursions(const program::Program& program, const program::Function& function, const Named& named)
      : function_(function), named_(named), labels_(labels_of(function)), scope_(series_scope(program, function)) {
    std::vector<bool> labelled(program.nodes.size(), false);
    for (const auto& [node, label] : labels_) labelled[at(node)] = true;
    series_ = program::series(program, function, labelled);
    stages_ = program::stages(series_.program);
    names_.resize(series_.program.nodes.size());
    made_.assign(series_.program.nodes.size(), false);
    for (const program::Quantity& quantity : function.quantities) add(quantity);
    prefix_ = "t";
    for (std::size_t i = 0; i < series_.program.nodes.size(); ++i)
      if (series_.alive[i] && series_.is_named[i] && series_.moves(static_cast<Index>(i))) make(static_cast<Index>(i));
    for (std::size_t i = 0; i < function.outputs.size(); ++i) store(i);
    for (const program::SeriesProduct& product : series_.products) add(product);
  }

  std::string values() const { return joined(values_); }
  std::string coefficients() const { return joined(coefficients_); }
  std::string factors() const {
    return factors_.declaration("results that are factors, or whose rates d_ are; their coefficients are kept");
  }
  std::string sums() const { return sums_.declaration("results that products are added up for"); }
  const std::string& products() const { return products_; }
  const Series& series() const { return series_; }

 private:
  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }

  const program::Node& node(Index i) const { return series_.program.nodes[at(i)]; }
  Recursion recursion(Index i) const { return series_.recursions[at(i)]; }
  // Given when it is first asked for: a recursion may speak of what follows.
  const std::string& name(Index i) {
    if (names_[at(i)].empty()) names_[at(i)] = new_name(i);
    return names_[at(i)];
  }

  static void append(std::vector<std::string>& to, const std::string& text, const std::string& indent) {
    for (std::string& line : wrapped(text, indent)) to.push_back(std::move(line));
  }
  void value_line(const std::string& text) { append(values_, "    " + text, "        "); }
  void coefficient_line(const std::string& text) { append(coefficients_, "    " + text, "        "); }
  void both(const std::string& text) {
    value_line(text);
    coefficient_line(text);
  }

  // The statements of a quantity under its equation.
  void add(const program::Quantity& quantity) {
    prefix_ = "t" + std::to_string(quantity.body) + "_";
    const std::size_t values = values_.size(), coefficients = coefficients_.size();
    for (const Ref entry : quantity.entries)
      if (series_.alive[at(entry.node)]) make(entry.node);
    const auto head = [&](std::vector<std::string>& lines, std::size_t from) {
      if (lines.size() == from) return;
      std::vector<std::string> heading;
      append(heading, "    // " + quantity.equation + (quantity.meaning.empty() ? "" : ": " + quantity.meaning),
             "    //   ");
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(from), heading.begin(), heading.end());
    };
    head(values_, values);
    head(coefficients_, coefficients);
  }

  // Statements for what stands below this result, then for itself where it has a name.
  void make(Index i) {
    if (made_[at(i)]) return;
    made_[at(i)] = true;
    const program::Operands from = operands(node(i));
    if (!is_held(i) && !series_.moves(i)) return;
    for (int j = 0; j < from.count; ++j) make(from.at[j]);
    if (is_held(i)) return hold(i);
    if (!series_.is_named[at(i)]) return;
    state(i);
  }

  // An operation on inputs, or one of parameters that prepare() does not do.
  bool is_held(Index i) const {
    return !series_.moves(i) && operands(node(i)).count > 0 && named_.prepared.count(i) == 0 &&
           stages_[at(i)] != Stage::constant;
  }

  std::string new_name(Index i) {
    if (const auto* variable = std::get_if<program::Variable>(&node(i)))
      return variable_name(series_.program, *variable, Stage::state, Syntax());
    const auto known = labels_.find(i);
    if (known != labels_.end()) return unique(known->second);
    return unique(prefix_ + std::to_string(++temporaries_[prefix_]));
  }

  // With its rate's name, d_<name>, for itself as well.
  std::string unique(const std::string& wish) {
    const std::string name = scope_.unique(wish);
    scope_.reserve("d_" + name);
    return name;
  }

  void hold(Index i) { both("[[maybe_unused]] const T " + name(i) + " = " + text(operation(i)) + ";"); }

  void state(Index i) {
    if (const auto* variable = std::get_if<program::Variable>(&node(i))) {
      if (variable->group == Group::time) {
        coefficient_line("[[maybe_unused]] const T t = T(k == 1 ? 1 : 0);");
      } else {
        const int place = variable->index + (variable->group == Group::y ? n_coordinates() : 0);
        both("[[maybe_unused]] const T " + name(i) + " = z[" + std::to_string(place) + "];");
      }
    } else {
      value_line("const T " + name(i) + " = " + text(operation(i)) + ";");
      coefficient_line("const T " + name(i) + " = " + coefficient(i) + ";");
    }
    keep(i);
  }

  int n_coordinates() const { return static_cast<int>(series_.program.names.x.size()); }

  void keep(Index i) {
    if (series_.is_factor[at(i)]) both("now[" + factors_.entry(name(i)) + "] = " + name(i) + ";");
    if (!series_.is_rate[at(i)]) return;
    value_line("now[" + factors_.entry("d_" + name(i)) + "] = T(0);");
    coefficient_line("const T d_" + name(i) + " = n * " + name(i) + ";");
    coefficient_line("now[" + factors_.entry("d_" + name(i)) + "] = d_" + name(i) + ";");
  }

  // The value of what is still.
  Term still(Index i) {
    if (const auto* constant = std::get_if<program::Constant>(&node(i))) {
      const double value = constant->value.rounded();
      return {"T(" + literal(std::abs(value)) + ")", 2, value < 0};
    }
    if (const auto* variable = std::get_if<program::Variable>(&node(i)))
      return {variable_name(series_.program, *variable, Stage::state, Syntax())};
    const auto prepared = named_.prepared.find(i);
    if (prepared != named_.prepared.end()) return {prepared->second.text, 2, prepared->second.negative};
    if (is_held(i)) {
      make(i);
      return {name(i)};
    }
    return operation(i);  // on constants
  }

  Term value(Index i) {
    if (!series_.moves(i)) return still(i);
    return series_.is_named[at(i)] ? Term{name(i)} : operation(i);
  }

  std::string argument(Index i) { return text(value(i)); }
  std::string call(const char* function, Index a) { return function + ("(" + argument(a)) + ")"; }

  // The value of an operation by those of its operands.
  Term operation(Index i) {
    return std::visit(program::Overloaded{
                          [&](const program::Constant&) { return still(i); },
                          [&](const program::Variable&) { return still(i); },
                          [&](const program::Add& op) { return sum(value(op.a), value(op.b)); },
                          [&](const program::Subtract& op) { return sum(value(op.a), negated(value(op.b))); },
                          [&](const program::Multiply& op) { return product(value(op.a), value(op.b)); },
                          [&](const program::Divide& op) { return quotient(value(op.a), value(op.b)); },
                          [&](const program::SquareRoot& op) { return Term{call("sqrt", op.a)}; },
                          [&](const program::Sine& op) { return Term{call("sin", op.a)}; },
                          [&](const program::Cosine& op) { return Term{call("cos", op.a)}; },
                          [&](const program::UnaryCall& op) { return Term{call(program::name(op.function), op.a)}; },
                          [&](const program::BinaryCall& op) {
                            return Term{Syntax().call(program::name(op.function)) + "(" + argument(op.a) + ", " +
                                        argument(op.b) + ")"};
                          },
                          [&](const program::Select& op) {
                            return Term{"select(" + below_zero(value(op.sign), "T(0)") + ", " + argument(op.a) + ", " +
                                        argument(op.b) + ")"};
                          },
                      },
                      node(i));
  }

  // The value that a factor had, in the coefficients' statements.
  std::string first(Index i) { return "v[" + factors_.entry(name(i)) + "]"; }
  Term value_then(Index i) { return series_.moves(i) ? Term{first(i)} : still(i); }
  std::string gathered(Index i) { return "s[" + sums_.entry(name(i)) + "][k]"; }

  // Coefficient k of an operand, empty where it is 0.
  std::optional<Term> newest(Index i) {
    if (!series_.moves(i)) return std::nullopt;
    return series_.is_named[at(i)] ? Term{name(i)} : combined(i);
  }

  // Coefficient k of a sum or product by the coefficients k of what moves; products of others are gathered.
  Term combined(Index i) {
    return std::visit(program::Overloaded{
                          [&](const program::Add& op) { return *total(newest(op.a), newest(op.b)); },
                          [&](const program::Subtract& op) { return *total(newest(op.a), opposite(newest(op.b))); },
                          [&](const program::Multiply& op) { return times(op); },
                          [&](const program::Divide& op) { return quotient(*newest(op.a), still(op.b)); },
                          [](const auto&) -> Term { throw InternalError("taylor: no linear operation"); },
                      },
                      node(i));
  }

  static std::optional<Term> opposite(std::optional<Term> a) { return a ? std::optional(negated(*a)) : std::nullopt; }
  static std::optional<Term> total(const std::optional<Term>& a, const std::optional<Term>& b) {
    if (a && b) return sum(*a, *b);
    return a ? a : b;
  }

  Term times(const program::Multiply& op) {
    if (!series_.moves(op.a)) return product(still(op.a), *newest(op.b));
    if (!series_.moves(op.b)) return product(*newest(op.a), still(op.b));
    return sum(product(*newest(op.a), Term{first(op.b)}), product(Term{first(op.a)}, *newest(op.b)));
  }

  std::string coefficient(Index i) {
    const bool has_sum = series_.is_sum[at(i)];
    switch (recursion(i)) {
      case Recursion::still:
      case Recursion::given:
        break;
      case Recursion::linear:
      case Recursion::product: {
        const Term newest = combined(i);
        return text(has_sum ? sum(Term{gathered(i)}, newest) : newest);
      }
      case Recursion::quotient: {
        const auto& op = std::get<program::Divide>(node(i));
        const Term rest = product(Term{first(i)}, *newest(op.b));
        const Term known = *total(newest(op.a), sum(Term{gathered(i)}, negated(rest)));
        return text(quotient(known, Term{first(op.b)}));
      }
      case Recursion::root: {
        const auto& op = std::get<program::SquareRoot>(node(i));
        return text(quotient(sum(*newest(op.a), Term{gathered(i)}), Term{"(T(2) * " + first(i) + ")"}));
      }
      case Recursion::integral:
        return integral(i);
      case Recursion::choice:
        return choice(i);
    }
    throw InternalError("taylor: a coefficient of what has none");
  }

  std::string integral(Index i) {
    Term known{gathered(i)};
    for (const program::Term& term : series_.terms[at(i)]) {
      const Term newest = product(Term{"d_" + name(term.a)}, Term{first(term.g)});
      known = sum(known, term.negative ? negated(newest) : newest);
    }
    return text(quotient(known, Term{"n"}));
  }

  std::string coefficient_of(Index i) {
    const std::optional<Term> term = newest(i);
    return term ? text(*term) : "T(0)";
  }

  std::string choice(Index i) {
    if (const auto* op = std::get_if<program::Select>(&node(i)))
      return "select(" + below_zero(value_then(op->sign), "T(0)") + ", " + coefficient_of(op->a) + ", " +
             coefficient_of(op->b) + ")";
    if (const auto* op = std::get_if<program::UnaryCall>(&node(i)))
      return "select(" + below_zero(value_then(op->a), "T(0)") + ", -" + coefficient_of(op->a) + ", " +
             coefficient_of(op->a) + ")";
    const auto& op = std::get<program::BinaryCall>(node(i));
    const std::string a = text(value_then(op.a)), b = text(value_then(op.b));
    const bool is_min = op.function == program::Binary::min;
    return "select(" + (is_min ? b + " < " + a : a + " < " + b) + ", " + coefficient_of(op.b) + ", " +
           coefficient_of(op.a) + ")";
  }

  // zdot: coefficient k of the rates is k + 1 times coefficient k + 1 of the state.
  void store(std::size_t i) {
    const Ref output = function_.outputs[i];
    const std::string place = "zdot[" + std::to_string(i) + "] = ";
    Term now = value(output.node);
    now.negative = now.negative != output.negative;
    value_line(place + text(now) + ";");
    std::optional<Term> later = newest(output.node);
    if (later) later->negative = later->negative != output.negative;
    coefficient_line(place + (later ? text(*later) : "T(0)") + ";");
  }

  void add(const program::SeriesProduct& product) {
    const std::string a = (product.by_rate ? "d_" : "") + name(product.a);
    products_ += " {" + sums_.entry(name(product.sum)) + ", " + factors_.entry(a) + ", " +
                 factors_.entry(name(product.b)) + ", " + (product.negative ? "-1" : "1") + "},";
  }

  const program::Function& function_;
  const Named& named_;
  std::unordered_map<Index, std::string> labels_;
  Scope scope_;
  Series series_;
  std::vector<Stage> stages_;
  std::vector<std::string> names_;
  std::vector<bool> made_;
  std::string prefix_;
  std::unordered_map<std::string, int> temporaries_;
  Rows factors_{"F"}, sums_{"S"};
  std::vector<std::string> values_, coefficients_;
  std::string products_;
};

bool chooses(const Series& series) {
  for (std::size_t i = 0; i < series.recursions.size(); ++i)
    if (series.alive[i] && series.recursions[i] == Recursion::choice) return true;
  return false;
}

}  // namespace

RecursionText recursion_text(const program::Program& program, const program::Function& function, const Named& named) {
  const Recursions recursions(program, function, named);
  return {recursions.values(),         recursions.coefficients(), recursions.factors(),
          recursions.sums(),           recursions.products(),     functions_called(recursions.series().program),
          chooses(recursions.series())};
}

}  // namespace kanec::emit
