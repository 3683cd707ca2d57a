// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/nesting.hpp"

#include <algorithm>

#include "generator/scene/place.hpp"

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

}  // namespace

void check_key_depth(std::string_view text, const std::string& file) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      i = behind_string(text, i);
      continue;
    }
    if (std::string_view(",=[]{}\n").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots >= most_parts) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n');
      fail({file, static_cast<int>(line)}, "a key of over " + std::to_string(most_parts) + " parts",
           "keys of a few parts, as body.initial.eps");
    }
    ++i;
  }
}

}  // namespace kanec::scene
