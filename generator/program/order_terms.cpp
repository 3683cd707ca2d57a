// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "generator/program/fusible.hpp"
#include "generator/program/passes.hpp"
#include "generator/program/sums.hpp"

namespace kanec::program {
namespace {

Program ordered(Program program) {
  const std::vector<Stage> stage = stages(program);
  const std::vector<bool> fusible = fusible_products(program, stage);
  Sums sums(program, TermOrder::as_written);
  for (auto& [index, terms] : sums.sums)
    if (stage[at(index)] == Stage::state)
      std::stable_partition(terms.begin(), terms.end(), [&](Ref term) { return !fusible[at(term.node)]; });
  Index now = 0;
  std::vector<Ref> to;
  rebuild(program, [&](Builder& builder, const Node& node, const Refs& operands) {
    const Index index = now++;
    const auto sum = sums.sums.find(index);
    const bool stays = sum == sums.sums.end() || stage[at(index)] != Stage::state;
    if (stays) {
      to.push_back(same_again(builder, node, operands));
      return to.back();
    }
    const auto made = [&to](Ref term) { return term.negative ? -to[at(term.node)] : to[at(term.node)]; };
    Ref result = made(sum->second[0]);
    for (std::size_t i = 1; i < sum->second.size(); ++i) result = builder.add(result, made(sum->second[i]));
    to.push_back(result);
    return result;
  });
  return program;
}

}  // namespace

Program order_terms(Program program) { return drop_dead(by_function(std::move(program), ordered)); }

}  // namespace kanec::program
