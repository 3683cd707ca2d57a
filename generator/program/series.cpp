// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/series.hpp"

#include <utility>

#include "generator/program/builder.hpp"
#include "generator/program/overloaded.hpp"
#include "runtime/base/error.hpp"

namespace kanec::program {
namespace {

bool is_sum_of_two(const Node& node) {
  return std::holds_alternative<Add>(node) || std::holds_alternative<Subtract>(node);
}

// Which recursion each result has; what functions need is appended, and classified in its turn.
class Classification {
 public:
  Classification(const Program& program, const Function& function) {
    builder_.nodes() = program.nodes;
    result_.program.names = program.names;
    result_.alive = reachable(program, function.outputs);
    for (std::size_t i = 0; i < program.nodes.size(); ++i)
      if (result_.alive[i]) join_partner(program.nodes[i]);
    for (std::size_t i = 0; i < builder_.nodes().size(); ++i) {
      result_.recursions.push_back(Recursion::still);
      result_.terms.emplace_back();
      result_.alive.resize(builder_.nodes().size(), true);
      if (result_.alive[i]) result_.recursions[i] = classified(static_cast<Index>(i));
    }
    result_.alive.resize(builder_.nodes().size(), true);
  }

  Series take() {
    result_.program.nodes = std::move(builder_.nodes());
    return std::move(result_);
  }

 private:
  // Sines need cosines, and the other way round.
  void join_partner(const Node& node) {
    if (const auto* sine = std::get_if<Sine>(&node)) partner<Cosine>(sine->a);
    if (const auto* cosine = std::get_if<Cosine>(&node)) partner<Sine>(cosine->a);
  }

  template <class Function>
  Index partner(Index a) {
    const std::vector<Node>& nodes = builder_.nodes();
    std::size_t i = 0;
    for (; i < nodes.size(); ++i)
      if (const auto* found = std::get_if<Function>(&nodes[i]); found != nullptr && found->a == a) break;
    if (i == nodes.size()) builder_.nodes().push_back(Function{a});
    result_.alive.resize(nodes.size(), true);
    result_.alive[i] = true;
    return static_cast<Index>(i);
  }

  bool moves(Index i) const { return result_.moves(i); }

  Recursion classified(Index i) {
    const Node node = builder_.nodes()[at(i)];  // a copy: derivatives are appended
    const Operands from = operands(node);
    bool any = false;
    for (int j = 0; j < from.count; ++j) any = any || moves(from.at[j]);
    if (const auto* variable = std::get_if<Variable>(&node)) {
      const bool is_still = variable->group == Group::parameter || variable->group == Group::input;
      return is_still ? Recursion::still : Recursion::given;
    }
    if (!any) return Recursion::still;
    return std::visit([&](const auto& operation) { return of(i, operation); }, node);
  }

  Recursion of(Index, const Constant&) { return Recursion::still; }
  Recursion of(Index, const Variable&) { return Recursion::given; }
  Recursion of(Index, const Add&) { return Recursion::linear; }
  Recursion of(Index, const Subtract&) { return Recursion::linear; }
  Recursion of(Index, const Multiply& op) {
    return moves(op.a) && moves(op.b) ? Recursion::product : Recursion::linear;
  }
  Recursion of(Index, const Divide& op) { return moves(op.b) ? Recursion::quotient : Recursion::linear; }
  Recursion of(Index, const SquareRoot&) { return Recursion::root; }
  Recursion of(Index, const Select&) { return Recursion::choice; }
  Recursion of(Index f, const Sine& op) { return integral(f, {{partner<Cosine>(op.a), op.a, false}}); }
  Recursion of(Index f, const Cosine& op) { return integral(f, {{partner<Sine>(op.a), op.a, true}}); }

  Recursion of(Index f, const UnaryCall& op) {
    const Ref value{f}, a{op.a}, one = builder_.constant(1.0);
    switch (op.function) {
      case Unary::abs:
        return Recursion::choice;
      case Unary::exp:
        return integral(f, {{f, op.a, false}});
      case Unary::log:
        return integral(f, {{builder_.divide(one, a).node, op.a, false}});
      case Unary::tan:
        return integral(f, {{builder_.add(one, builder_.multiply(value, value)).node, op.a, false}});
      case Unary::tanh:
        return integral(f, {{builder_.subtract(one, builder_.multiply(value, value)).node, op.a, false}});
      case Unary::asin:
      case Unary::acos: {
        const Ref cosine = builder_.square_root(builder_.subtract(one, builder_.multiply(a, a)));
        return integral(f, {{builder_.divide(one, cosine).node, op.a, op.function == Unary::acos}});
      }
    }
    throw InternalError("series: no such function");
  }

  Recursion of(Index f, const BinaryCall& op) {
    const Ref value{f}, a{op.a}, b{op.b};
    switch (op.function) {
      case Binary::min:
      case Binary::max:
        return Recursion::choice;
      case Binary::atan2: {
        const Ref square = builder_.add(builder_.multiply(a, a), builder_.multiply(b, b));
        return integral(
            f, {{builder_.divide(b, square).node, op.a, false}, {builder_.divide(a, square).node, op.b, true}});
      }
      case Binary::pow: {
        const Index by_base = builder_.multiply(b, builder_.divide(value, a)).node;
        return integral(
            f, {{by_base, op.a, false}, {builder_.multiply(value, builder_.call(Unary::log, a)).node, op.b, false}});
      }
    }
    throw InternalError("series: no such function");
  }

  // The terms of operands that move; derivatives by others were appended in vain and are not alive.
  Recursion integral(Index f, const std::vector<Term>& terms) {
    const std::size_t before = result_.alive.size();
    result_.alive.resize(builder_.nodes().size(), false);
    for (const Term& term : terms) {
      if (!moves(term.a)) continue;
      result_.terms[at(f)].push_back(term);
      revive(term.g, before);
    }
    return Recursion::integral;
  }

  // This one of the nodes appended from `first` on, and what it is made of.
  void revive(Index i, std::size_t first) {
    if (at(i) < first) return;
    result_.alive[at(i)] = true;
    const Operands from = operands(builder_.nodes()[at(i)]);
    for (int j = 0; j < from.count; ++j) revive(from.at[j], first);
  }

  Builder builder_;
  Series result_;
};

// What of each result is kept, and the products of coefficients.
class Storage {
 public:
  Storage(Series& series, const Function& function) : series_(series) {
    const std::size_t size = series.program.nodes.size();
    for (auto* list : {&series.is_factor, &series.is_rate, &series.is_sum}) list->assign(size, false);
    series.is_named.resize(size, false);
    count_uses(function);
    for_each([&](Index i) { demand(i); });
    std::vector<bool> has_products(size, false);
    for_each([&](Index i) { name_sums(i, has_products); });
    for_each([&](Index i) { multiply(i); });
  }

 private:
  const Node& node(Index i) const { return series_.program.nodes[at(i)]; }
  Recursion recursion(Index i) const { return series_.recursions[at(i)]; }

  template <class Work>
  void for_each(Work work) {
    for (std::size_t i = 0; i < series_.program.nodes.size(); ++i)
      if (series_.alive[i] && series_.moves(static_cast<Index>(i))) work(static_cast<Index>(i));
  }

  void count_uses(const Function& function) {
    uses_.assign(series_.program.nodes.size(), 0);
    user_.assign(series_.program.nodes.size(), -1);
    for_each([&](Index i) {
      const Operands from = operands(node(i));
      for (int j = 0; j < from.count; ++j) {
        ++uses_[at(from.at[j])];
        user_[at(from.at[j])] = i;
      }
    });
    for (const Ref output : function.outputs) name(output.node);
    for_each([&](Index i) {
      if (uses_[at(i)] > 1) name(i);
    });
  }

  void name(Index i) {
    if (series_.moves(i)) series_.is_named[at(i)] = true;
  }
  void factor(Index i) {
    if (!series_.moves(i)) return;
    name(i);
    series_.is_factor[at(i)] = true;
  }

  // What the recursion of a result needs of its operands and of itself.
  void demand(Index i) {
    const Operands from = operands(node(i));
    switch (recursion(i)) {
      case Recursion::product:
        for (int j = 0; j < 2; ++j) factor(from.at[j]);
        return;
      case Recursion::quotient:
        factor(from.at[1]);
        return factor(i);
      case Recursion::root:
        return factor(i);
      case Recursion::integral:
        name(i);
        for (const Term& term : series_.terms[at(i)]) {
          factor(term.g);
          name(term.a);
          series_.is_rate[at(term.a)] = true;
        }
        return;
      case Recursion::choice:
        name(i);
        for (int j = 0; j < from.count; ++j) factor(from.at[j]);
        return;
      case Recursion::given:
        return name(i);
      case Recursion::still:
      case Recursion::linear:
        return;
    }
  }

  // A sum takes up the products that stand in it; what multiplies a sum of products needs its value.
  void name_sums(Index i, std::vector<bool>& has_products) {
    const bool is_linear = is_sum_of_two(node(i));
    bool has = recursion(i) == Recursion::product;
    const Operands from = operands(node(i));
    for (int j = 0; j < from.count && is_linear; ++j)
      has = has || (has_products[at(from.at[j])] && !series_.is_named[at(from.at[j])]);
    has_products[at(i)] = has;
    const Index user = user_[at(i)];
    if (has && (user < 0 || !is_sum_of_two(node(user)))) name(i);
  }

  void multiply(Index i) {
    const Operands from = operands(node(i));
    switch (recursion(i)) {
      case Recursion::product: {
        bool negative = false;
        const Index sum = owner(i, negative);
        return add({sum, from.at[0], from.at[1], false, negative});
      }
      case Recursion::quotient:
        return add({i, i, from.at[1], false, true});
      case Recursion::root:
        return add({i, i, i, false, true});
      case Recursion::integral:
        for (const Term& term : series_.terms[at(i)]) add({i, term.a, term.g, true, term.negative});
        return;
      default:
        return;
    }
  }

  void add(const SeriesProduct& product) {
    series_.is_sum[at(product.sum)] = true;
    series_.products.push_back(product);
  }

  Index owner(Index i, bool& negative) const {
    while (!series_.is_named[at(i)]) {
      const Index user = user_[at(i)];
      const auto* difference = std::get_if<Subtract>(&node(user));
      if (difference != nullptr && difference->b == i) negative = !negative;
      i = user;
    }
    return i;
  }

  Series& series_;
  std::vector<int> uses_;
  std::vector<Index> user_;  // the last one
};

}  // namespace

Series series(const Program& program, const Function& function, const std::vector<bool>& named) {
  if (!function.placements.empty()) throw InternalError("series: of a function with placements");
  Series result = Classification(program, function).take();
  result.is_named = named;
  Storage(result, function);
  return result;
}

}  // namespace kanec::program
