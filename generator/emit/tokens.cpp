// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/tokens.hpp"

#include <algorithm>
#include <cctype>

namespace kanec::emit {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Cutter {
 public:
  explicit Cutter(std::string_view code) : code_(code) {}

  std::vector<Token> all() {
    while (at_ < code_.size()) next();
    list_.push_back({});
    return std::move(list_);
  }

 private:
  bool follows(std::string_view text) const { return code_.compare(at_, text.size(), text) == 0; }

  void skip_behind(std::string_view text) {
    const std::size_t found = code_.find(text, at_);
    at_ = found == std::string_view::npos ? code_.size() : found + text.size();
  }

  void take(TokenKind kind, std::size_t length) {
    list_.push_back({kind, code_.substr(at_, length)});
    at_ += length;
  }

  void next() {
    const char c = code_[at_];
    if (c == ' ' || c == '\n') return void(++at_);
    if (c == '#' || follows("//")) return skip_behind("\n");
    if (follows("/*")) return skip_behind("*/");
    if (follows("[[")) return skip_behind("]]");
    if (follows("KANEC_CALL(")) return skip_behind("KANEC_CALL");
    if (c == '"' || c == '\'') return take(TokenKind::text, quoted());
    if (is_digit(c)) return take(TokenKind::number, number());
    if (is_word(c)) return take(TokenKind::word, run([](char d) { return is_word(d); }));
    take(TokenKind::mark, follows("::") || follows("->") || follows("==") ? 2 : 1);
  }

  template <class Fits>
  std::size_t run(Fits fits) const {
    return static_cast<std::size_t>(
               std::find_if_not(code_.begin() + static_cast<std::ptrdiff_t>(at_), code_.end(), fits) - code_.begin()) -
           at_;
  }

  // With an exponent's sign: "1e-05".
  std::size_t number() const {
    char before = ' ';
    return run([&before](char c) {
      const bool is_sign = (c == '-' || c == '+') && (before == 'e' || before == 'E');
      before = c;
      return is_sign || is_word(c) || c == '.';
    });
  }

  std::size_t quoted() const {
    std::size_t end = at_ + 1;
    while (end < code_.size() && code_[end] != code_[at_]) end += code_[end] == '\\' ? 2 : 1;
    return std::min(end + 1, code_.size()) - at_;
  }

  std::string_view code_;
  std::size_t at_ = 0;
  std::vector<Token> list_;
};

}  // namespace

std::vector<Token> tokens(std::string_view code) { return Cutter(code).all(); }

}  // namespace kanec::emit
