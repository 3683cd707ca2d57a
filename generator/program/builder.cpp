// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/builder.hpp"

namespace kanec::program {

Ref Builder::append(const Node& node) {
  nodes_.push_back(node);
  return {static_cast<Index>(nodes_.size()) - 1, false};
}

Ref Builder::add(Ref a, Ref b) {
  if (a.negative && b.negative) return {append(Add{a.node, b.node}).node, true};
  if (a.negative) return append(Subtract{b.node, a.node});
  if (b.negative) return append(Subtract{a.node, b.node});
  return append(Add{a.node, b.node});
}

Ref Builder::square_root(Ref a) {
  if (a.negative) a = append(Subtract{constant(0.0).node, a.node});
  return append(SquareRoot{a.node});
}

}  // namespace kanec::program
