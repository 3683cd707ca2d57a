// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/fold.hpp"
#include "generator/program/passes.hpp"
#include "generator/program/sums.hpp"

namespace kanec::program {
namespace {

std::size_t at(Index index) { return static_cast<std::size_t>(index); }

// A term as factor · base; a constant has no base.
struct Multiple {
  Number factor = 1.0;
  Index base = -1;
  bool is_product = false;
};

class Collection {
 public:
  explicit Collection(const Program& program) : program_(program), sums_(program) {
    std::vector<Index> unchanged;
    for (const auto& [sum, terms] : sums_.sums)
      if (!collects(terms)) unchanged.push_back(sum);
    for (const Index sum : unchanged) sums_.leave(program, sum);
  }

  Program result() {
    Index now = 0;
    std::vector<Ref> to;
    return rebuilt(program_, [&](Builder& builder, const Node& node, const Refs& operands) {
      const Index index = now++;
      const auto sum = sums_.sums.find(index);
      const bool whole = sum != sums_.sums.end();
      to.push_back(whole                     ? made(builder, sum->second, to)
                   : sums_.inner[at(index)] ? Ref{}
                                            : same_again(builder, node, operands));
      return to.back();
    });
  }

 private:
  const Constant* constant(Index index) const { return std::get_if<Constant>(&program_.nodes[at(index)]); }

  Multiple multiple(Ref term) const {
    Multiple result;
    if (const Constant* number = constant(term.node)) {
      result.factor = number->value;
    } else {
      result.base = term.node;
      if (const auto* product = std::get_if<Multiply>(&program_.nodes[at(term.node)]))
        for (const auto& [factor, base] : {std::pair(product->a, product->b), std::pair(product->b, product->a)})
          if (const Constant* found = constant(factor)) result = {found->value, base, true};
    }
    if (term.negative) result.factor = -result.factor;
    return result;
  }

  // Whether two terms make one, and save an operation.
  bool collects(const Terms& terms) const {
    std::map<Index, bool> known;  // by base: whether one of its terms is a constant or a product
    for (const Ref term : terms) {
      const Multiple m = multiple(term);
      const bool saves = m.base < 0 || m.is_product;
      const auto [before, is_new] = known.emplace(m.base, saves);
      if (!is_new && (saves || before->second)) return true;
      before->second = before->second || saves;
    }
    return false;
  }

  // Terms of one base in the place of the first of them.
  Ref made(Builder& builder, const Terms& terms, const std::vector<Ref>& to) const {
    const auto node = [&](Ref term) { return term.negative ? -to[at(term.node)] : to[at(term.node)]; };
    std::vector<bool> done(terms.size(), false);
    Ref result;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (done[i]) continue;
      Multiple all = multiple(terms[i]);
      bool saves = all.base < 0;
      std::vector<std::size_t> others;
      for (std::size_t j = i + 1; j < terms.size(); ++j) {
        const Multiple other = multiple(terms[j]);
        if (done[j] || other.base != all.base) continue;
        others.push_back(j);
        all.factor = all.factor + other.factor;
        saves = saves || all.is_product || other.is_product;
      }
      Ref term = node(terms[i]);
      if (saves && !others.empty()) {
        for (const std::size_t j : others) done[j] = true;
        const Ref factor = fold::literal(builder, all.factor);
        term = all.base < 0 ? factor : fold::product(builder, factor, to[at(all.base)]);
      }
      result = i == 0 ? term : fold::sum(builder, result, term);
    }
    return result;
  }

  const Program& program_;
  Sums sums_;
};

}  // namespace

Program collect(const Program& program) {
  return by_function(program, [](const Program& alone) { return Collection(alone).result(); });
}

}  // namespace kanec::program
