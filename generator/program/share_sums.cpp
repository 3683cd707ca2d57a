// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "generator/program/passes.hpp"
#include "generator/program/sums.hpp"

namespace kanec::program {
namespace {

// Two terms up to a common sign, and the sums that hold both. Terms from `first_pair` on are pairs taken out before.
struct Pair {
  Index a, b;  // a < b
  bool opposite;
  auto operator<=>(const Pair&) const = default;
};

class SumSharing {
 public:
  explicit SumSharing(Program program)
      : program_(std::move(program)), first_pair_(static_cast<Index>(program_.nodes.size())) {
    Sums sums(program_, TermOrder::as_written);
    inner_ = std::move(sums.inner);
    sums_ = std::move(sums.sums);
    while (take_out_a_round()) {
    }
  }

  Program result() {
    Index now = 0;
    std::map<Index, Ref> pair_nodes;
    std::vector<Ref> to;
    rebuild(program_, [&](Builder& builder, const Node& node, const Refs& operands) {
      const Index index = now++;
      const auto sum = sums_.find(index);
      const bool plain = sum == sums_.end();
      to.push_back(plain ? (inner_[at(index)] ? Ref{} : same_again(builder, node, operands))
                         : chain(builder, sum->second, to, pair_nodes));
      return to.back();
    });
    return std::move(program_);
  }

 private:
  static Pair pair_of(Ref a, Ref b) {
    if (a.node > b.node) std::swap(a, b);
    return {a.node, b.node, a.negative != b.negative};
  }

  // Of each node and pair: a term of two and more sums.
  std::vector<bool> terms_of_several() const {
    std::vector<bool> result(at(first_pair_) + pairs_.size());
    std::vector<Index> first(result.size(), -1);  // sum that has the term
    for (const auto& [index, terms] : sums_)
      for (const Ref term : terms) {
        Index& known = first[at(term.node)];
        if (known < 0) known = index;
        result[at(term.node)] = result[at(term.node)] || known != index;
      }
    return result;
  }

  // Takes out the pairs found in two and more sums, the most frequent first. False when there was none.
  bool take_out_a_round() {
    std::vector<std::pair<Pair, Index>> found;
    const std::vector<bool> common = terms_of_several();
    for (const auto& [index, all] : sums_) {
      Terms terms;  // those that another sum has as well: a sum over all bodies has thousands, and few of these
      std::copy_if(all.begin(), all.end(), std::back_inserter(terms), [&](Ref term) { return common[at(term.node)]; });
      for (std::size_t i = 0; i < terms.size(); ++i)
        for (std::size_t j = i + 1; j < terms.size(); ++j)
          if (terms[i].node != terms[j].node) found.emplace_back(pair_of(terms[i], terms[j]), index);
    }
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
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (terms[i].node == pair.a || terms[i].node == pair.b) found.push_back(i);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t j = i + 1; j < found.size(); ++j)
        if (pair_of(terms[found[i]], terms[found[j]]) == pair)
          return {static_cast<Index>(found[i]), static_cast<Index>(found[j])};
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

  Program program_;
  Index first_pair_;
  std::vector<bool> inner_;
  std::map<Index, Terms> sums_;
  std::vector<Pair> pairs_;
};

}  // namespace

Program share_sums(Program program) {
  return by_function(std::move(program), [](Program alone) { return SumSharing(std::move(alone)).result(); });
}

}  // namespace kanec::program
