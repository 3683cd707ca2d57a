// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/share.hpp"

#include <array>
#include <bit>
#include <functional>
#include <unordered_map>
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {

std::uint64_t operation(const Node& node) {
  std::uint64_t function = 0;
  if (const auto* unary = std::get_if<UnaryCall>(&node)) function = static_cast<std::uint64_t>(unary->function);
  if (const auto* binary = std::get_if<BinaryCall>(&node)) function = static_cast<std::uint64_t>(binary->function);
  return node.index() | function << 8;
}

bool commutes(const Node& node) {
  if (const auto* call = std::get_if<BinaryCall>(&node))
    return call->function == Binary::min || call->function == Binary::max;
  return std::holds_alternative<Add>(node) || std::holds_alternative<Multiply>(node);
}

namespace {

// Operation and operands, commutative ones in ascending order; of constants the bits.
using Key = std::array<std::uint64_t, 4>;

struct Hash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t part : key) hash = (std::rotl(hash, 23) ^ part) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

Key key_of(const Node& node) {
  Key key = {operation(node), 0, 0, 0};
  if (const auto* constant = std::get_if<Constant>(&node)) {
    // adding 0.0 makes one of the two zeros
    key[1] = std::bit_cast<std::uint64_t>(constant->value.high + 0.0);
    key[2] = std::bit_cast<std::uint64_t>(constant->value.low + 0.0);
  } else if (const auto* variable = std::get_if<Variable>(&node)) {
    key[1] = static_cast<std::uint64_t>(variable->group);
    key[2] = static_cast<std::uint64_t>(variable->index);
  } else {
    const Operands from = operands(node);
    for (int i = 0; i < from.count; ++i) key[static_cast<std::size_t>(i) + 1] = static_cast<std::uint64_t>(from.at[i]);
    if (commutes(node) && key[1] > key[2]) std::swap(key[1], key[2]);
  }
  return key;
}

class Sharing {
 public:
  explicit Sharing(std::size_t size) { known_.reserve(size); }

  Ref operator()(Builder& builder, const Node& node, const Refs& operands) {
    const Ref made = same_again(builder, node, operands);
    const Node& now = builder.nodes().back();
    if (const auto* difference = std::get_if<Subtract>(&now)) {
      const auto reversed = known_.find(key_of(Subtract{difference->b, difference->a}));
      if (reversed != known_.end()) return drop(builder, -Ref{reversed->second, made.negative});
    }
    const auto [entry, is_new] = known_.emplace(key_of(now), made.node);
    return is_new ? made : drop(builder, {entry->second, made.negative});
  }

 private:
  static Ref drop(Builder& builder, Ref instead) {
    builder.nodes().pop_back();
    return instead;
  }
  std::unordered_map<Key, Index, Hash> known_;
};

}  // namespace

Program share(const Program& program) {
  Sharing sharing(program.nodes.size());
  return rebuilt(program, std::ref(sharing));
}

}  // namespace kanec::program
