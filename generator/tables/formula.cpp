// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/tables/formula.hpp"

#include <cctype>
#include <numbers>
#include <string_view>
#include <vector>

#include "generator/scene/component.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec::emit {
namespace {

using scene::Call;
using scene::Component;
using scene::ExpressionNode;
using Kind = ExpressionNode::Kind;

// What binds a text together, from the weakest.
enum class Binding { sum, sign, product, power, whole };

struct Part {
  std::string text;
  Binding binding = Binding::whole;
};

std::string within(const Part& part, Binding least) { return part.binding < least ? "(" + part.text + ")" : part.text; }

// "\theta_{4,1}", "s_{2}", "\varepsilon_{4}^{(2)}"; of speeds with a dot, ω by its component.
std::string letter_of(const Component& component, bool is_speed) {
  const std::string body = std::to_string(component.body), index = std::to_string(component.index + 1);
  if (component.kind == Component::Kind::attitude)
    return is_speed ? "\\omega_{" + body + "," + index + "}" : "\\varepsilon_{" + index + "}^{(" + body + ")}";
  const std::string letter = component.kind == Component::Kind::turn ? "\\theta" : "s";
  return (is_speed ? "\\dot " : "") + letter + "_{" + body + (component.count > 1 ? "," + index : "") + "}";
}

const char* name_of(Call call) {
  switch (call) {
    case Call::sin:
      return "\\sin";
    case Call::cos:
      return "\\cos";
    case Call::tan:
      return "\\tan";
    case Call::asin:
      return "\\arcsin";
    case Call::acos:
      return "\\arccos";
    case Call::atan2:
      return "\\operatorname{atan2}";
    case Call::exp:
      return "\\exp";
    case Call::log:
      return "\\ln";
    case Call::min:
      return "\\min";
    case Call::max:
      return "\\max";
    case Call::tanh:
      return "\\tanh";
    case Call::sqrt:
    case Call::abs:
    case Call::pow:
      break;
  }
  return "";
}

class Formula {
 public:
  explicit Formula(const scene::Scene& scene) : scene_(scene), layout_(scene) {}

  std::string of(const scene::Expression& expression) {
    parts_.clear();
    for (const ExpressionNode& node : expression.nodes) parts_.push_back(part(node));
    return parts_.back().text;
  }

 private:
  const Part& a(const ExpressionNode& node) const { return parts_[static_cast<std::size_t>(node.a)]; }
  const Part& b(const ExpressionNode& node) const { return parts_[static_cast<std::size_t>(node.b)]; }

  Part part(const ExpressionNode& node) const {
    switch (node.kind) {
      case Kind::number:
        return number(node.value);
      case Kind::time:
        return {"t"};
      case Kind::coordinate:
      case Kind::speed:
        return {letter(node)};
      case Kind::parameter:
        return {latex_name(scene_.parameters[static_cast<std::size_t>(node.index)].name)};
      case Kind::input:
        return {latex_name(scene_.inputs[static_cast<std::size_t>(node.index)].name)};
      case Kind::negate:
        return {"-" + within(a(node), Binding::product), Binding::sign};
      case Kind::add:
        return {a(node).text + " + " + within(b(node), Binding::product), Binding::sum};
      case Kind::subtract:
        return {a(node).text + " - " + within(b(node), Binding::product), Binding::sum};
      case Kind::multiply:
        return product(a(node), " \\cdot ", b(node));
      case Kind::divide:
        return product(a(node), " / ", b(node));
      case Kind::call:
        break;
    }
    return call(node);
  }

  // A sign before the first factor is one before the product.
  static Part product(const Part& first, const char* sign, const Part& second) {
    const std::string text = within(first, Binding::sign) + sign + within(second, Binding::power);
    return {text, text[0] == '-' ? Binding::sign : Binding::product};
  }

  static Part number(double value) {
    if (value == std::numbers::pi) return {"\\pi"};
    const std::string text = latex_number(value);
    const bool is_power = text.find('^') != std::string::npos;
    return {text, text[0] == '-' ? Binding::sign : is_power ? Binding::product : Binding::whole};
  }

  Part call(const ExpressionNode& node) const {
    if (node.call == Call::sqrt) return {"\\sqrt{" + a(node).text + "}"};
    if (node.call == Call::abs) return {"\\lvert " + a(node).text + " \\rvert"};
    if (node.call == Call::pow) {
      const std::string base = within(a(node), Binding::whole);
      const bool is_raised = base.find('^') != std::string::npos;
      return {base + (is_raised ? "{}^{" : "^{") + b(node).text + "}", Binding::power};
    }
    const std::string second = scene::n_arguments(node.call) == 2 ? ", " + b(node).text : "";
    return {name_of(node.call) + ("(" + a(node).text) + second + ")"};
  }

  std::string letter(const ExpressionNode& node) const {
    const bool is_speed = node.kind == Kind::speed;
    for (const Component& c : is_speed ? scene::speed_components(scene_) : scene::components(scene_))
      if ((is_speed ? index_in_y(layout_, c) : index_in_x(layout_, c)) == node.index) return letter_of(c, is_speed);
    return "";
  }

  const scene::Scene& scene_;
  scene::Layout layout_;
  std::vector<Part> parts_;  // by node
};

}  // namespace

std::string latex_formula(const scene::Scene& scene, const scene::Expression& expression) {
  return Formula(scene).of(expression);
}

std::string latex_number(double value) {
  const std::string text = shortest(value);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const std::string mantissa = text.substr(0, exponent);
  const std::string power = "10^{" + std::to_string(std::stoi(text.substr(exponent + 1))) + "}";
  return mantissa == "1" ? power : mantissa == "-1" ? "-" + power : mantissa + " \\cdot " + power;
}

namespace {

// Does a command of letters end here? A space behind it is part of it.
bool ends_in_command(const std::string& text) {
  std::size_t i = text.size();
  while (i > 0 && std::isalpha(static_cast<unsigned char>(text[i - 1]))) --i;
  return i > 0 && i < text.size() && text[i - 1] == '\\';
}

// Is the last thing a sign between two terms?
bool ends_in_sign(const std::string& text) {
  const std::size_t n = text.size();
  return n > 1 && text[n - 2] == ' ' && std::string_view("+-/=").find(text[n - 1]) != std::string_view::npos;
}

}  // namespace

std::string latex_breaks(const std::string& formula) {
  std::string result;
  int braces = 0, parentheses = 0, brackets = 0;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const char c = formula[i];
    const bool is_escaped = i > 0 && formula[i - 1] == '\\';
    braces += is_escaped ? 0 : (c == '{') - (c == '}');
    parentheses += braces > 0 ? 0 : (c == '(') - (c == ')');
    brackets += braces > 0 ? 0 : (c == '[') - (c == ']');
    if (c != ' ' || braces > 0 || ends_in_command(result) || ends_in_sign(result)) {
      result += c;
      continue;
    }
    const bool is_in_list = result.back() == ',' || result.back() == ';';
    const bool is_at_sign =
        formula.compare(i, 3, " + ") == 0 || formula.compare(i, 3, " - ") == 0 || formula.compare(i, 3, " = ") == 0;
    result += is_in_list ? "\\; " : " ";
    const bool is_inner = parentheses > 0 || (brackets > 0 && is_at_sign);
    result += !is_in_list && !is_at_sign ? "\\brkfac " : is_inner ? "\\brkin " : "\\brk ";
  }
  return result;
}

std::string latex_word(const std::string& name) {
  std::string result;
  for (const char c : name) result += c == '_' ? "\\_\\allowbreak{}" : fit::latex(std::string(1, c));
  return result;
}

std::string latex_name(const std::string& name) { return "\\text{" + fit::latex(name) + "}"; }

}  // namespace kanec::emit
