// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/elimination.hpp"

#include <map>
#include <set>
#include <utility>

#include "generator/program/fold.hpp"

namespace kanec::program {
namespace {

// Vertices are results, and before and behind them the columns and the outputs. An edge's weight is the derivative of
// its head with respect to its tail.
class Elimination {
 public:
  Elimination(Builder& builder, const std::vector<Ref>& outputs, const std::vector<Column>& columns)
      : builder_(builder), n_nodes_(builder.nodes().size()), n_columns_(columns.size()), n_outputs_(outputs.size()) {
    heads_.resize(n_nodes_ + n_columns_ + n_outputs_);
    tails_.resize(heads_.size());
    const std::vector<bool> alive = reachable({{}, builder.nodes(), {}}, outputs);
    for (std::size_t i = 0; i < n_nodes_; ++i)
      if (alive[i]) enter(i, columns);
    for (std::size_t i = 0; i < n_outputs_; ++i) {
      const auto node = static_cast<std::size_t>(outputs[i].node);
      if (depends(node)) connect(node, output(i), sign(outputs[i].negative));
    }
  }

  std::vector<Ref> entries(Order order) {
    if (order == Order::fewest_products) eliminate_cheapest();
    for (std::size_t i = n_nodes_; i-- > 0;) eliminate(i);
    std::vector<Ref> result(n_outputs_ * n_columns_, builder_.constant(0.0));
    for (std::size_t j = 0; j < n_columns_; ++j)
      for (const auto& [head, weight] : heads_[column(j)]) result[(head - output(0)) * n_columns_ + j] = weight;
    return result;
  }

 private:
  std::size_t column(std::size_t j) const { return n_nodes_ + j; }
  std::size_t output(std::size_t i) const { return n_nodes_ + n_columns_ + i; }
  bool depends(std::size_t node) const { return !tails_[node].empty(); }
  Ref sign(bool negative) { return negative ? -builder_.constant(1.0) : builder_.constant(1.0); }

  // A node's edges from its operands that depend on a column; a variable's from the columns that move it.
  void enter(std::size_t node, const std::vector<Column>& columns) {
    const Node op = builder_.nodes()[node];
    if (const auto* variable = std::get_if<Variable>(&op))
      for (std::size_t j = 0; j < n_columns_; ++j)
        for (const Direction& direction : columns[j])
          if (direction.variable.group == variable->group && direction.variable.index == variable->index)
            connect(column(j), node, direction.amount);
    const Operands from = operands(op);
    for (int i = 0; i < from.count; ++i) {
      const auto operand = static_cast<std::size_t>(from.at[i]);
      if (depends(operand)) connect(operand, node, partial(builder_, static_cast<Index>(node), i));
    }
  }

  void connect(std::size_t tail, std::size_t head, Ref weight) {
    const auto known = heads_[tail].find(head);
    if (known != heads_[tail].end()) weight = fold::sum(builder_, known->second, weight);
    if (fold::is(builder_, weight, 0)) return disconnect(tail, head);
    heads_[tail][head] = weight;
    tails_[head].insert(tail);
  }

  void disconnect(std::size_t tail, std::size_t head) {
    heads_[tail].erase(head);
    tails_[head].erase(tail);
  }

  // Every path through the node becomes an edge past it.
  void eliminate(std::size_t node) {
    const auto tails = std::exchange(tails_[node], {});
    const auto heads = std::exchange(heads_[node], {});
    for (const std::size_t tail : tails) {
      const Ref weight = heads_[tail].at(node);
      heads_[tail].erase(node);
      for (const auto& [head, next] : heads) connect(tail, head, fold::product(builder_, next, weight));
    }
    for (const auto& [head, next] : heads) tails_[head].erase(node);
  }

  // Results from which no path leads to an output.
  void eliminate_dead() {
    for (std::size_t i = n_nodes_; i-- > 0;)
      if (heads_[i].empty()) eliminate(i);
  }

  bool is_unit(Ref weight) const { return fold::is(builder_, weight, 1) || fold::is(builder_, weight, -1); }

  std::size_t products(std::size_t node) const {
    std::size_t in = 0, out = 0;
    for (const std::size_t tail : tails_[node]) in += !is_unit(heads_[tail].at(node));
    for (const auto& [head, weight] : heads_[node]) out += !is_unit(weight);
    return in * out;
  }

  void eliminate_cheapest() {
    eliminate_dead();
    std::set<std::pair<std::size_t, std::size_t>> queue;
    std::vector<std::size_t> cost(n_nodes_, 0);
    const auto update = [&](std::size_t i) {
      if (i >= n_nodes_) return;
      queue.erase({cost[i], i});
      cost[i] = products(i);
      queue.insert({cost[i], i});
    };
    for (std::size_t i = 0; i < n_nodes_; ++i)
      if (depends(i)) update(i);
    while (!queue.empty()) {
      const std::size_t node = queue.begin()->second;
      queue.erase(queue.begin());
      std::vector<std::size_t> neighbours(tails_[node].begin(), tails_[node].end());
      for (const auto& [head, weight] : heads_[node]) neighbours.push_back(head);
      eliminate(node);
      for (const std::size_t i : neighbours) update(i);
    }
  }

  Builder& builder_;
  std::size_t n_nodes_, n_columns_, n_outputs_;
  std::vector<std::map<std::size_t, Ref>> heads_;  // of a vertex, with the edges' weights
  std::vector<std::set<std::size_t>> tails_;
};

}  // namespace

std::vector<Ref> jacobian_entries(Builder& builder, const std::vector<Ref>& outputs, const std::vector<Column>& columns,
                                  Order order) {
  return Elimination(builder, outputs, columns).entries(order);
}

}  // namespace kanec::program
