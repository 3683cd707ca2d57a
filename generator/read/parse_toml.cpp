// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/parse_toml.hpp"

#include <algorithm>

#include "generator/scene/place.hpp"
#include "runtime/base/utf8.hpp"

namespace kanec::scene {
namespace {

constexpr int most_parts = 32;

// Behind the string that begins at `begin`: basic or literal, on one line or, in three quotes, on several.
std::size_t behind_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool multi_line = text.substr(begin, 3) == three;
  for (std::size_t i = begin + (multi_line ? 3 : 1); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\')
      ++i;
    else if (multi_line && text.substr(i, 3) == three)
      // the last quotes close, up to two before them are content
      return std::min(text.find_first_not_of(quote, i), i + 5);
    else if (!multi_line && (text[i] == quote || text[i] == '\n'))
      return i + 1;
  }
  return text.size();
}

// Goes through what stands outside of comments and texts in quotes.
class Guard {
 public:
  Guard(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void pass() {
    at_ = text_.starts_with("\xef\xbb\xbf") ? 3 : 0;  // a byte order mark
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (c == '"' || c == '\'')
        at_ = behind_string(text_, at_);
      else
        see(c);
    }
  }

 private:
  void see(char c) {
    if (std::string_view(",=[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
    if (c == '.' && ++dots_ >= most_parts)
      refuse("a key of over " + std::to_string(most_parts) + " parts", "keys of a few parts, as body.initial.eps");
    if (static_cast<unsigned char>(c) >= 0x80)
      refuse("the character " + in_quotes(first_character(text_.substr(at_)).bytes),
             "ASCII outside of comments and texts in quotes");
    ++at_;
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& allowed) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    fail({file_, static_cast<int>(line)}, found, allowed);
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int dots_ = 0;
};

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  Guard(text, file).pass();
  try {
    return toml::parse(text, std::string_view(file));
  } catch (const toml::parse_error& error) {
    const auto line = static_cast<int>(error.source().begin.line);
    fail({file, line}, std::string(error.description()), "TOML 1.0 (https://toml.io)");
  }
}

}  // namespace kanec::scene
