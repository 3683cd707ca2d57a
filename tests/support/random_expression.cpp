// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_expression.hpp"

#include <array>
#include <charconv>
#include <string>
#include <utility>

namespace kanec::test {
namespace {

using scene::Call;
using Node = scene::ExpressionNode;
using Kind = Node::Kind;

constexpr std::array<const char*, 14> call_names = {"sin", "cos", "tan", "asin", "acos", "atan2", "sqrt",
                                                    "exp", "log", "abs", "min",  "max",  "pow",   "tanh"};

// A part of the expression in the making: its node and its text.
struct Part {
  int node;
  std::string text;
};

struct Leaf {
  Node node;
  std::string text;
};

class Writer {
 public:
  Writer(Random& random, std::vector<Leaf> leaves) : random_(random), leaves_(std::move(leaves)) {}

  Part number(double value) {
    if (value < 0) return negate(number(-value));
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return add({.kind = Kind::number, .value = value}, std::string(text, end));
  }
  Part negate(const Part& a) { return add({.kind = Kind::negate, .a = a.node}, "(-" + a.text + ")"); }
  Part two(Kind kind, const char* sign, const Part& a, const Part& b) {
    return add({.kind = kind, .a = a.node, .b = b.node}, "(" + a.text + " " + sign + " " + b.text + ")");
  }
  Part plus(const Part& a, const Part& b) { return two(Kind::add, "+", a, b); }
  Part times(const Part& a, const Part& b) { return two(Kind::multiply, "*", a, b); }
  Part call(Call function, const Part& a) {
    return add({.kind = Kind::call, .call = function, .a = a.node}, name(function) + "(" + a.text + ")");
  }
  Part call(Call function, const Part& a, const Part& b) {
    return add({.kind = Kind::call, .call = function, .a = a.node, .b = b.node},
               name(function) + "(" + a.text + ", " + b.text + ")");
  }

  Part time() { return add(leaves_[0].node, leaves_[0].text); }
  Part leaf() {
    const Leaf& leaf = leaves_[static_cast<std::size_t>(random_.below(static_cast<int>(leaves_.size())))];
    return add(leaf.node, leaf.text);
  }

  // Anything, at most `depth` operations above the leaves; of the size of its leaves.
  Part any(int depth) {
    if (depth == 0) return random_.chance(0.2) ? number(random_.uniform(-2, 2)) : leaf();
    const int operation = random_.below(8);
    if (operation >= 5) return some_call(depth - 1);
    const Part a = operation == 2 ? within(depth - 1) : any(depth - 1);
    if (operation == 4) return negate(a);
    const Part b = operation == 3 ? above_zero(depth - 1) : any(depth - 1);
    constexpr std::array<std::pair<Kind, const char*>, 4> binary = {
        {{Kind::add, "+"}, {Kind::subtract, "-"}, {Kind::multiply, "*"}, {Kind::divide, "/"}}};
    return two(binary[static_cast<std::size_t>(operation)].first, binary[static_cast<std::size_t>(operation)].second, a,
               b);
  }

  // Within ±1.
  Part within(int depth) { return call(random_.chance(0.5) ? Call::sin : Call::tanh, any(depth)); }

  scene::Expression finished(const Part& part) { return {part.text, std::move(nodes_)}; }

 private:
  static std::string name(Call function) { return call_names[static_cast<std::size_t>(function)]; }

  Part add(const Node& node, std::string text) {
    nodes_.push_back(node);
    return {static_cast<int>(nodes_.size()) - 1, std::move(text)};
  }

  // Between 0.5 and 2.5.
  Part above_zero(int depth) {
    const Part middle = number(1.5);
    return plus(middle, within(depth));
  }
  // Within ±0.8.
  Part inside(int depth) {
    const Part limit = number(0.8);
    return times(limit, within(depth));
  }

  // Every function, on arguments of its domain.
  Part some_call(int depth) {
    const auto function = static_cast<Call>(random_.below(14));
    switch (function) {
      case Call::tan:
      case Call::asin:
      case Call::acos:
        return call(function, inside(depth));
      case Call::exp:
        return call(function, within(depth));
      case Call::sqrt:
      case Call::log:
        return call(function, above_zero(depth));
      case Call::atan2:
      case Call::min:
      case Call::max:
        return two_arguments(function, depth);
      case Call::pow:
        return power(depth);
      default:
        return call(function, any(depth));
    }
  }

  Part two_arguments(Call function, int depth) {
    const Part a = any(depth);
    return call(function, a, function == Call::atan2 ? above_zero(depth) : any(depth));
  }

  // A whole exponent on any base, any exponent on a positive one.
  Part power(int depth) {
    const bool whole = random_.chance(0.5);
    const Part base = whole ? within(depth) : above_zero(depth);
    return call(Call::pow, base, whole ? number(2 + random_.below(2)) : within(depth));
  }

  Random& random_;
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
};

void append(std::vector<Leaf>& leaves, Kind kind, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    leaves.push_back({{.kind = kind, .index = static_cast<int>(i)}, names[i]});
}

std::vector<std::string> names(const std::vector<scene::Named>& list) {
  std::vector<std::string> out;
  for (const scene::Named& named : list) out.push_back(named.name);
  return out;
}

}  // namespace

scene::Expression random_expression(Random& random, const scene::Scene& scene, double size) {
  std::vector<Leaf> leaves = {{{.kind = Kind::time}, "t"}};
  append(leaves, Kind::coordinate, scene::coordinate_names(scene));
  append(leaves, Kind::speed, scene::speed_names(scene));
  append(leaves, Kind::parameter, names(scene.parameters));
  append(leaves, Kind::input, names(scene.inputs));
  Writer write(random, leaves);
  const Part factor = write.number(random.uniform(0.3, 1) * size);
  const Part rest = write.any(1 + random.below(3));
  return write.finished(write.times(factor, rest));
}

// value + amplitude sin(ν (t + a random part)).
scene::Expression random_course(Random& random, const scene::Scene& scene, double value, double amplitude) {
  std::vector<Leaf> leaves = {{{.kind = Kind::time}, "t"}};
  append(leaves, Kind::parameter, names(scene.parameters));
  Writer write(random, leaves);
  const Part frequency = write.number(random.uniform(0.5, 3)), time = write.time(), shift = write.within(1);
  const Part swing = write.call(Call::sin, write.times(frequency, write.plus(time, shift)));
  const Part middle = write.number(value), width = write.number(amplitude);
  return write.finished(write.plus(middle, write.times(width, swing)));
}

}  // namespace kanec::test
