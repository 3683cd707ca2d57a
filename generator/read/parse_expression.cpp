// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/parse_expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

constexpr double largest_number = 1e60;  // as of the numbers of a scene
using Kind = ExpressionNode::Kind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// A number, a name, a sign or the end.
struct Token {
  enum class Type { number, name, sign, end };
  Type type = Type::end;
  std::size_t begin = 0;  // from 0
  std::string_view text;
  double value = 0.0;
  bool is(char sign) const { return type == Type::sign && text[0] == sign; }
};

class Parser {
 public:
  Parser(std::string_view text, const Place& place, const std::vector<ExpressionName>& names)
      : text_(text), place_(place), names_(names) {}

  Expression parse() {
    if (text_.size() > longest_expression)
      fail(place_, "an expression of " + std::to_string(text_.size()) + " characters",
           "at most " + std::to_string(longest_expression));
    advance();
    sum();
    if (token_.type != Token::Type::end) refuse("an operator, + - * / ^, or the end");
    out_.text = std::string(text_);
    return std::move(out_);
  }

 private:
  // One level of nesting, for its lifetime.
  class Level {
   public:
    explicit Level(Parser& parser) : depth_(parser.depth_) {
      if (++depth_ > deepest_expression)
        parser.refuse("at most " + std::to_string(deepest_expression) + " levels of parentheses, signs and powers");
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };

  int sum() {
    int a = product();
    while (token_.is('+') || token_.is('-')) {
      const Kind kind = token_.is('+') ? Kind::add : Kind::subtract;
      advance();
      a = append({.kind = kind, .a = a, .b = product()});
    }
    return a;
  }

  int product() {
    int a = signed_power();
    while (token_.is('*') || token_.is('/')) {
      const Kind kind = token_.is('*') ? Kind::multiply : Kind::divide;
      advance();
      a = append({.kind = kind, .a = a, .b = signed_power()});
    }
    return a;
  }

  int signed_power() {
    const Level level(*this);
    if (!token_.is('-') && !token_.is('+')) return power();
    const bool negative = token_.is('-');
    advance();
    const int a = signed_power();
    return negative ? append({.kind = Kind::negate, .a = a}) : a;
  }

  int power() {
    const int a = operand();
    if (!token_.is('^')) return a;
    advance();
    return append({.kind = Kind::call, .call = Call::pow, .a = a, .b = signed_power()});
  }

  int operand() {
    if (token_.is('(')) return parenthesis();
    if (token_.type == Token::Type::number) {
      const double value = token_.value;
      advance();
      return append({.kind = Kind::number, .value = value});
    }
    if (token_.type != Token::Type::name) refuse("a number, a name, a function or (");
    const Token name = token_;
    advance();
    return token_.is('(') ? call(name) : append(meaning(name));
  }

  int parenthesis() {
    advance();
    const int a = sum();
    expect(')', "an operator or )");
    return a;
  }

  int call(const Token& name) {
    const auto& calls = call_names();
    const auto found = std::find(calls.begin(), calls.end(), name.text);
    if (found == calls.end()) refuse(name, "a function: " + one_of(calls, name.text));
    const auto function = static_cast<Call>(found - calls.begin());
    const bool two = n_arguments(function) == 2;
    advance();
    ExpressionNode node{.kind = Kind::call, .call = function, .a = sum()};
    if (two) {
      expect(',', "an operator, or a comma: " + *found + " takes two arguments");
      node.b = sum();
    }
    expect(')', "an operator or ): " + *found + " takes " + (two ? "two arguments" : "one argument"));
    return append(node);
  }

  ExpressionNode meaning(const Token& token) {
    if (token.text == "pi") return {.kind = Kind::number, .value = std::numbers::pi};
    const auto& calls = call_names();
    if (std::find(calls.begin(), calls.end(), token.text) != calls.end())
      fail(place_, shown(token) + ", a function without its argument", std::string(token.text) + "(…)");
    const auto found = std::find_if(names_.begin(), names_.end(), [&](const auto& n) { return n.name == token.text; });
    if (found == names_.end()) refuse(token, "a name: " + one_of(known_names(), token.text));
    if (!found->refusal.empty()) fail(place_, shown(token) + ", " + found->refusal, usable_names(token.text));
    return found->node;
  }

  std::vector<std::string> known_names() const {
    std::vector<std::string> out = {"pi"};
    for (const ExpressionName& name : names_)
      if (name.refusal.empty()) out.push_back(name.name);
    return out;
  }

  std::string usable_names(std::string_view found) const { return "another name: " + one_of(known_names(), found); }

  int append(const ExpressionNode& node) {
    out_.nodes.push_back(node);
    return static_cast<int>(out_.nodes.size()) - 1;
  }

  void expect(char sign, const std::string& allowed) {
    if (!token_.is(sign)) refuse(allowed);
    advance();
  }

  // `"x" in column 3 of "2*x"`
  std::string shown(const Token& token) const {
    const std::string column = std::to_string(token.begin + 1);
    if (token.type == Token::Type::end) return "the end in column " + column + " of " + in_quotes(text_);
    return in_quotes(token.text) + " in column " + column + " of " + in_quotes(text_);
  }

  [[noreturn]] void refuse(const Token& token, const std::string& allowed) const {
    fail(place_, shown(token), allowed);
  }
  [[noreturn]] void refuse(const std::string& allowed) const { refuse(token_, allowed); }

  void advance() {
    std::size_t begin = token_.begin + token_.text.size();
    while (begin < text_.size() && (text_[begin] == ' ' || text_[begin] == '\t')) ++begin;
    token_ = {Token::Type::end, begin, text_.substr(begin, 0)};
    if (begin == text_.size()) return;
    const char c = text_[begin];
    if (is_digit(c) || c == '.')
      number();
    else if (is_letter(c))
      name();
    else
      sign();
  }

  void number() {
    const char* const begin = text_.data() + token_.begin;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), token_.value);
    token_.type = Token::Type::number;
    token_.text = text_.substr(token_.begin, std::max<std::size_t>(1, static_cast<std::size_t>(end - begin)));
    // a number too small for a double is zero to every purpose, but its digits were meant: refused as well
    if (error != std::errc() || token_.value > largest_number)
      refuse("a number, in magnitude at most " + shortest(largest_number));
  }

  void name() {
    std::size_t end = token_.begin;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    token_.type = Token::Type::name;
    token_.text = text_.substr(token_.begin, end - token_.begin);
  }

  void sign() {
    token_.type = Token::Type::sign;
    token_.text = text_.substr(token_.begin, character_size());
    if (std::string_view("+-*/^(),").find(token_.text[0]) == std::string_view::npos)
      refuse("numbers, names, + - * / ^ ( ) and commas");
    if (text_.substr(token_.begin, 2) == "**") refuse("one *, or ^ for a power");
  }

  // Bytes of the UTF-8 character that begins here.
  std::size_t character_size() const {
    std::size_t size = 1;
    while (token_.begin + size < text_.size() &&
           (static_cast<unsigned char>(text_[token_.begin + size]) & 0xC0) == 0x80)
      ++size;
    return size;
  }

  std::string_view text_;
  const Place& place_;
  const std::vector<ExpressionName>& names_;
  Token token_;
  Expression out_;
  int depth_ = 0;
};

}  // namespace

Expression parse_expression(std::string_view text, const Place& place, const std::vector<ExpressionName>& names) {
  return Parser(text, place, names).parse();
}

const std::vector<std::string>& call_names() {
  static const std::vector<std::string> names = {"sin", "cos", "tan", "asin", "acos", "atan2", "sqrt",
                                                 "exp", "log", "abs", "min",  "max",  "pow",   "tanh"};
  return names;
}

}  // namespace kanec::scene
