// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/canonical.hpp"

#include <numeric>
#include <unordered_map>
#include <utility>

#include "generator/program/share.hpp"
#include "runtime/base/error.hpp"

namespace kanec::program {
namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t product = (a ^ (b + 0x9e3779b97f4a7c15u + (a << 6))) * 0xff51afd7ed558ccdu;
  return product ^ (product >> 29);
}

class Form {
 public:
  Form(const Program& program, const Sections& sections, std::size_t number, const std::vector<Stage>& stages,
       const Signs& signs)
      : program_(program), sections_(sections), number_(static_cast<Index>(number)), stages_(stages), signs_(signs) {
    const Section& section = sections.list[number];
    for (const Ref entry : section.entries) root(entry);
    for (const Store& store : section.stores) root(store.value);
  }

  Canonical result() { return std::move(result_); }

 private:
  bool is_local(Index node) const { return sections_.home[at(node)] == number_; }

  void root(Ref ref) {
    number(ref.node);
    result_.key.push_back(-100 - signs_.now(ref).negative);
    result_.key.push_back(operand({ref.node, false}));
  }

  // Of the operations below a node, what is read by its kind.
  std::uint64_t shape(Index node) {
    if (!is_local(node)) return static_cast<std::uint64_t>(leaf_kind(program_.nodes[at(node)], stages_[at(node)])) + 1;
    const auto known = shapes_.find(node);
    if (known != shapes_.end()) return known->second;
    std::uint64_t value = kind(node) + 100;
    const Operands from = operands(program_.nodes[at(node)]);
    for (const std::size_t i : order(node)) value = mixed(value, shape(from.at[i]));
    shapes_[node] = value;
    return value;
  }

  // The order in which operands are taken; of a commutative operation by their shapes.
  std::vector<std::size_t> order(Index node) {
    const Operands from = operands(program_.nodes[at(node)]);
    std::vector<std::size_t> result(static_cast<std::size_t>(from.count));
    std::iota(result.begin(), result.end(), std::size_t{0});
    const bool is_sum = kind(node) == sum || kind(node) == difference;
    if (is_sum && is_minus(node, 0) != is_minus(node, 1)) {
      if (is_minus(node, 0)) std::swap(result[0], result[1]);
    } else if ((is_sum || commutes(program_.nodes[at(node)])) && shape(from.at[1]) < shape(from.at[0])) {
      std::swap(result[0], result[1]);
    }
    return result;
  }

  // Of a sum's or difference's terms, as it is made.
  bool is_minus(Index node, int i) const {
    const bool subtracted = i == 1 && std::holds_alternative<Subtract>(program_.nodes[at(node)]);
    return signs_.negative(node, i) != subtracted;
  }

  // The operation as it is made.
  std::uint64_t kind(Index node) const {
    const std::uint64_t own = operation(program_.nodes[at(node)]);
    if (own != sum && own != difference) return own;
    return is_minus(node, 0) != is_minus(node, 1) ? difference : sum;
  }

  void number(Index node) {
    if (!is_local(node) || places_.count(node) > 0) return;
    std::vector<std::size_t> taken = order(node);
    const Operands from = operands(program_.nodes[at(node)]);
    for (const std::size_t i : taken) number(from.at[i]);
    result_.key.push_back(static_cast<std::int64_t>(kind(node)));
    for (const std::size_t i : taken) {
      const bool is_constant = std::holds_alternative<Constant>(program_.nodes[at(from.at[i])]);
      const bool other = is_constant && signs_.constant_flipped(node, static_cast<int>(i));
      result_.key.push_back(operand({from.at[i], other}));
    }
    places_[node] = static_cast<std::int64_t>(result_.operations.size());
    result_.operations.push_back(node);
    result_.order.push_back(std::move(taken));
  }

  std::int64_t operand(Ref ref) {
    if (is_local(ref.node)) return places_.at(ref.node);
    result_.leaves.push_back(ref);
    return -1 - static_cast<std::int64_t>(leaf_kind(program_.nodes[at(ref.node)], stages_[at(ref.node)]));
  }

  const Program& program_;
  const Sections& sections_;
  Index number_;
  const std::vector<Stage>& stages_;
  const Signs& signs_;
  const std::uint64_t sum = operation(Add{}), difference = operation(Subtract{});
  std::unordered_map<Index, std::uint64_t> shapes_;
  std::unordered_map<Index, std::int64_t> places_;
  Canonical result_;
};

}  // namespace

LeafKind leaf_kind(const Node& node, Stage stage) {
  if (std::holds_alternative<Constant>(node)) return LeafKind::constant;
  if (stage == Stage::parameter) return LeafKind::prepared;
  const auto* variable = std::get_if<Variable>(&node);
  if (variable == nullptr) return LeafKind::frame;
  switch (variable->group) {
    case Group::x:
      return LeafKind::x;
    case Group::y:
      return LeafKind::y;
    case Group::ydot:
      return LeafKind::ydot;
    case Group::input:
      return LeafKind::input;
    case Group::time:
      return LeafKind::time;
    case Group::parameter:
      return LeafKind::prepared;
  }
  throw InternalError("canonical: a variable of no group");
}

Canonical canonical(const Program& program, const Sections& sections, std::size_t number,
                    const std::vector<Stage>& stages, const Signs& signs) {
  return Form(program, sections, number, stages, signs).result();
}

}  // namespace kanec::program
