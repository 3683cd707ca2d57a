// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "generator/program/fold.hpp"
#include "generator/program/passes.hpp"
#include "generator/program/sums.hpp"

namespace kanec::program {
namespace {

// A term as factor · base; a constant has no base.
struct Multiple {
  Number factor = 1.0;
  Index base = -1;
  bool is_product = false;
};

class Collection {
 public:
  explicit Collection(Program program) : program_(std::move(program)), sums_(program_) {
    std::vector<Index> unchanged;
    for (const auto& [sum, terms] : sums_.sums)
      if (!collects(terms)) unchanged.push_back(sum);
    for (const Index sum : unchanged) sums_.leave(program_, sum);
  }

  Program result() {
    Index now = 0;
    std::vector<Ref> to;
    rebuild(program_, [&](Builder& builder, const Node& node, const Refs& operands) {
      const Index index = now++;
      const auto sum = sums_.sums.find(index);
      const bool whole = sum != sums_.sums.end();
      to.push_back(whole                    ? made(builder, sum->second, to)
                   : sums_.inner[at(index)] ? Ref{}
                                            : same_again(builder, node, operands));
      return to.back();
    });
    return std::move(program_);
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

  // Of terms of one base, two at least.
  static bool saves(const std::vector<Multiple>& multiples, const std::vector<std::size_t>& alike) {
    return multiples[alike[0]].base < 0 ||
           std::any_of(alike.begin(), alike.end(), [&](std::size_t i) { return multiples[i].is_product; });
  }

  static Ref in_one(Builder& builder, const std::vector<Multiple>& multiples, const std::vector<std::size_t>& alike,
                    const std::vector<Ref>& to) {
    Number sum = multiples[alike[0]].factor;
    for (std::size_t i = 1; i < alike.size(); ++i) sum = sum + multiples[alike[i]].factor;
    const Index base = multiples[alike[0]].base;
    const Ref factor = fold::literal(builder, sum);
    return base < 0 ? factor : fold::product(builder, factor, to[at(base)]);
  }

  // Terms of one base in the place of the first of them.
  Ref made(Builder& builder, const Terms& terms, const std::vector<Ref>& to) const {
    const auto node = [&](Ref term) { return term.negative ? -to[at(term.node)] : to[at(term.node)]; };
    std::vector<Multiple> multiples;
    std::map<Index, std::vector<std::size_t>> of_base;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      multiples.push_back(multiple(terms[i]));
      of_base[multiples.back().base].push_back(i);
    }
    Ref result;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const std::vector<std::size_t>& alike = of_base.at(multiples[i].base);
      const bool collected = alike.size() > 1 && saves(multiples, alike);
      if (collected && alike[0] != i) continue;
      const Ref term = collected ? in_one(builder, multiples, alike, to) : node(terms[i]);
      result = i == 0 ? term : fold::sum(builder, result, term);
    }
    return result;
  }

  Program program_;
  Sums sums_;
};

}  // namespace

Program collect(Program program) {
  return by_function(std::move(program), [](Program alone) { return Collection(std::move(alone)).result(); });
}

}  // namespace kanec::program
