// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

std::size_t at(Index index) { return static_cast<std::size_t>(index); }

bool is_sum(const Node& node) { return std::holds_alternative<Add>(node) || std::holds_alternative<Subtract>(node); }

// Two terms up to a common sign, and the sums that hold both. Terms from `first_pair` on are pairs taken out before.
struct Pair {
  Index a, b;  // a < b
  bool opposite;
  auto operator<=>(const Pair&) const = default;
};

class SumSharing {
 public:
  explicit SumSharing(const Program& program)
      : program_(program), first_pair_(static_cast<Index>(program.nodes.size())) {
    find_inner();
    for (Index i = 0; i < first_pair_; ++i)
      if (is_sum(program.nodes[at(i)]) && !inner_[at(i)]) flatten({i, false}, sums_[i]);
    while (take_out_a_round()) {
    }
  }

  Program result() {
    Index now = 0;
    std::map<Index, Ref> pair_nodes;
    std::vector<Ref> to;
    return rebuilt(program_, [&](Builder& builder, const Node& node, Ref a, Ref b) {
      const Index index = now++;
      const auto sum = sums_.find(index);
      const bool plain = sum == sums_.end();
      to.push_back(plain ? (inner_[at(index)] ? Ref{} : same_again(builder, node, a, b))
                         : chain(builder, sum->second, to, pair_nodes));
      return to.back();
    });
  }

 private:
  using Terms = std::vector<Ref>;

  // A sum is inner when its one use is in another sum of its stage and no name or output stands for it.
  void find_inner() {
    const std::vector<Stage> stage = stages(program_);
    std::vector<int> uses(program_.nodes.size(), 0);
    std::vector<bool> used_in_sum(program_.nodes.size(), false);
    for (std::size_t user = 0; user < program_.nodes.size(); ++user) {
      const Operands from = operands(program_.nodes[user]);
      for (int i = 0; i < from.count; ++i) {
        const std::size_t operand = at(from.at[i]);
        ++uses[operand];
        if (is_sum(program_.nodes[user]) && stage[user] == stage[operand]) used_in_sum[operand] = true;
      }
    }
    for (const Ref ref : all_outputs(program_)) uses[at(ref.node)] += 2;
    for (const Function& function : program_.functions)
      for (const Quantity& quantity : function.quantities)
        for (const Ref ref : quantity.entries) uses[at(ref.node)] += 2;
    inner_.resize(program_.nodes.size());
    for (std::size_t i = 0; i < inner_.size(); ++i)
      inner_[i] = is_sum(program_.nodes[i]) && uses[i] == 1 && used_in_sum[i];
  }

  void flatten(Ref ref, Terms& terms) const {
    const Operands from = operands(program_.nodes[at(ref.node)]);
    const bool difference = std::holds_alternative<Subtract>(program_.nodes[at(ref.node)]);
    for (int i = 0; i < 2; ++i) {
      const Ref operand{from.at[i], ref.negative != (difference && i == 1)};
      if (inner_[at(operand.node)])
        flatten(operand, terms);
      else
        terms.push_back(operand);
    }
  }

  static Pair pair_of(Ref a, Ref b) {
    if (a.node > b.node) std::swap(a, b);
    return {a.node, b.node, a.negative != b.negative};
  }

  // Takes out the pairs found in two and more sums, the most frequent first. False when there was none.
  bool take_out_a_round() {
    std::vector<std::pair<Pair, Index>> found;
    for (const auto& [index, terms] : sums_)
      for (std::size_t i = 0; i < terms.size(); ++i)
        for (std::size_t j = i + 1; j < terms.size(); ++j)
          if (terms[i].node != terms[j].node) found.emplace_back(pair_of(terms[i], terms[j]), index);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<std::pair<Pair, std::vector<Index>>> frequent;
    for (std::size_t i = 0; i + 1 < found.size(); ++i) {
      if (found[i].first != found[i + 1].first) continue;
      if (frequent.empty() || frequent.back().first != found[i].first)
        frequent.push_back({found[i].first, {found[i].second}});
      frequent.back().second.push_back(found[i + 1].second);
    }
    std::stable_sort(frequent.begin(), frequent.end(),
                     [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
    bool any = false;
    for (const auto& [pair, where] : frequent) any |= take_out(pair, where);
    return any;
  }

  bool take_out(const Pair& pair, const std::vector<Index>& where) {
    std::vector<Index> holders;
    for (const Index index : where)
      if (places(sums_[index], pair).first >= 0) holders.push_back(index);
    const bool only_whole_sums =
        std::all_of(holders.begin(), holders.end(), [&](Index i) { return sums_[i].size() == 2; });
    if (holders.size() < 2 || only_whole_sums) return false;
    const Index name = first_pair_ + static_cast<Index>(pairs_.size());
    pairs_.push_back(pair);
    for (const Index index : holders) {
      Terms& terms = sums_[index];
      const auto [i, j] = places(terms, pair);
      const bool negative = terms[at(i)].node == pair.a ? terms[at(i)].negative : terms[at(j)].negative;
      terms[at(i)] = {name, negative};
      terms.erase(terms.begin() + j);
    }
    return true;
  }

  // Where the two terms of the pair stand with the right signs, (-1, -1) where they do not.
  static std::pair<Index, Index> places(const Terms& terms, const Pair& pair) {
    for (std::size_t i = 0; i < terms.size(); ++i)
      for (std::size_t j = i + 1; j < terms.size(); ++j)
        if (terms[i].node != terms[j].node && pair_of(terms[i], terms[j]) == pair)
          return {static_cast<Index>(i), static_cast<Index>(j)};
    return {-1, -1};
  }

  Ref made(Builder& builder, Ref term, const std::vector<Ref>& to, std::map<Index, Ref>& pair_nodes) const {
    Ref ref;
    if (term.node < first_pair_) {
      ref = to[at(term.node)];
    } else if (const auto known = pair_nodes.find(term.node); known != pair_nodes.end()) {
      ref = known->second;
    } else {
      const Pair& pair = pairs_[at(term.node - first_pair_)];
      const Ref a = made(builder, {pair.a, false}, to, pair_nodes);
      const Ref b = made(builder, {pair.b, pair.opposite}, to, pair_nodes);
      ref = builder.add(a, b);
      pair_nodes.emplace(term.node, ref);
    }
    return term.negative ? -ref : ref;
  }

  Ref chain(Builder& builder, const Terms& terms, const std::vector<Ref>& to, std::map<Index, Ref>& pair_nodes) const {
    Ref result = made(builder, terms[0], to, pair_nodes);
    for (std::size_t i = 1; i < terms.size(); ++i)
      result = builder.add(result, made(builder, terms[i], to, pair_nodes));
    return result;
  }

  const Program& program_;
  Index first_pair_;
  std::vector<bool> inner_;
  std::map<Index, Terms> sums_;
  std::vector<Pair> pairs_;
};

// Appends the nodes and functions of another program.
void append(Program& program, const Program& other) {
  const auto first = static_cast<Index>(program.nodes.size());
  const auto moved = [first](Ref ref) { return Ref{ref.node + first, ref.negative}; };
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  for (const Node& node : other.nodes) {
    const Operands from = operands(node);
    same_again(builder, node, {from.at[0] + first, false}, {from.at[1] + first, false});
  }
  program.nodes = std::move(builder.nodes());
  for (Function function : other.functions) {
    std::transform(function.outputs.begin(), function.outputs.end(), function.outputs.begin(), moved);
    for (Quantity& quantity : function.quantities)
      std::transform(quantity.entries.begin(), quantity.entries.end(), quantity.entries.begin(), moved);
    program.functions.push_back(std::move(function));
  }
}

}  // namespace

// Function by function: what they have in common is no saving to any of them, and so each has the same code whatever
// others the program holds.
Program share_sums(const Program& program) {
  Program result{program.names, {}, {}};
  for (const Function& function : program.functions) {
    const Program alone = drop_dead({program.names, program.nodes, {function}});
    append(result, SumSharing(alone).result());
  }
  return share(result);
}

}  // namespace kanec::program
