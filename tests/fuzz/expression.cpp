// Any text as an expression: it is one whose steps stand in order, or an error of kanec in one line.
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "generator/read/parse_expression.hpp"
#include "runtime/base/error.hpp"

namespace {

using kanec::scene::ExpressionNode;

const std::vector<kanec::scene::ExpressionName> names = {{"t", {.kind = ExpressionNode::Kind::time}},
                                                         {"theta_1", {.kind = ExpressionNode::Kind::coordinate}},
                                                         {"k_1", {.kind = ExpressionNode::Kind::parameter}},
                                                         {"locked", {}, "is locked at 0.3"}};

void require_order(const kanec::scene::Expression& expression) {
  const auto size = static_cast<int>(expression.nodes.size());
  for (int i = 0; i < size; ++i) {
    const ExpressionNode& node = expression.nodes[static_cast<std::size_t>(i)];
    if (node.kind >= ExpressionNode::Kind::negate && (node.a < 0 || node.a >= i || node.b >= i)) std::abort();
  }
  if (size == 0) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    require_order(kanec::scene::parse_expression({reinterpret_cast<const char*>(data), size}, {"f"}, names));
  } catch (const kanec::InternalError&) {
    std::abort();
  } catch (const kanec::Error& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
