// Signs of a function's results chosen so that constants carry them: a - 0.3 b and a + 0.2 b become sums alike, of
// constants -0.3 and 0.2. No value changes but in sign, and no operation is spent. Not: a new program.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

class Signs {
 public:
  Signs(const Program& program, const Function& function, const std::vector<Stage>& stages);

  // Whether the result is made as its negative.
  bool flipped(Index node) const { return flipped_[at(node)]; }
  Ref now(Ref ref) const { return {ref.node, ref.negative != flipped(ref.node)}; }

  // Whether a constant that is operand i of the node stands with the other sign.
  bool constant_flipped(Index node, int i) const;
  // Whether operand i, made or constant as above, enters the node's operation with a minus; of a difference, before its
  // own.
  bool negative(Index node, int i) const;

 private:
  static std::size_t at(Index index) { return static_cast<std::size_t>(index); }
  bool is_literal(Index node) const { return std::holds_alternative<Constant>(program_.nodes[at(node)]); }
  bool is_own(Index node) const;
  bool is_flexible(Index node) const;
  bool yields(Index node) const { return is_literal(node) || deferred_[at(node)]; }
  bool term(Index node, int i) const;
  void count_uses(const Function& function);
  void fix_arguments();
  void choose(Index node);
  bool of_sum(Index node) const;
  void hand_down(Index node);

  const Program& program_;
  const std::vector<Stage>& stages_;
  std::vector<bool> needed_, fixed_, flexible_, deferred_, flipped_;
  std::vector<int> uses_;
  std::vector<std::optional<bool>> wanted_, first_use_;  // negative
};

}  // namespace kanec::program
