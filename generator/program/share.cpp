// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/share.hpp"

#include <array>
#include <bit>
#include <functional>
#include <utility>
#include <vector>

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

// Operations that are there, found by their keys: places in a table at least twice as long, each in the first that was
// free from where its key points.
class Known {
 public:
  explicit Known(std::size_t size) : places_(std::bit_ceil(2 * size + 2), -1) {}

  // The place of such a node, which has -1 where there is none.
  Index& at(const std::vector<Node>& nodes, const Key& key) {
    std::size_t i = Hash{}(key);
    for (;; ++i) {
      Index& place = places_[i & (places_.size() - 1)];
      if (place < 0 || key_of(nodes[static_cast<std::size_t>(place)]) == key) return place;
    }
  }

 private:
  std::vector<Index> places_;
};

class Sharing {
 public:
  explicit Sharing(std::size_t size) : known_(size) {}

  Ref operator()(Builder& builder, const Node& node, const Refs& operands) {
    const Ref made = same_again(builder, node, operands);
    const Node& now = builder.nodes().back();
    if (const auto* difference = std::get_if<Subtract>(&now)) {
      const Index reversed = known_.at(builder.nodes(), key_of(Subtract{difference->b, difference->a}));
      if (reversed >= 0) return drop(builder, -Ref{reversed, made.negative});
    }
    Index& known = known_.at(builder.nodes(), key_of(now));
    if (known >= 0) return drop(builder, {known, made.negative});
    known = made.node;
    return made;
  }

 private:
  static Ref drop(Builder& builder, Ref instead) {
    builder.nodes().pop_back();
    return instead;
  }
  Known known_;
};

}  // namespace

Program share(Program program) {
  Sharing sharing(program.nodes.size());
  rebuild(program, std::ref(sharing));
  return program;
}

}  // namespace kanec::program
