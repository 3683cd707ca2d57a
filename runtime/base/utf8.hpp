// UTF-8 taken apart into characters, and into bytes that are none. Not: what characters mean.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace kanec {

// A Unicode scalar value and the bytes that it stands in; or one byte with which no character begins (is_valid false).
struct Character {
  char32_t value = 0;
  std::string_view bytes;
  bool is_valid = false;
};

// The first character of a text that is not empty. Shortest forms alone, no surrogates, nothing beyond U+10FFFF.
Character first_character(std::string_view text);

// visit(character) for all of them, in order.
template <class Visit>
void for_characters(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const Character character = first_character(text);
    text.remove_prefix(character.bytes.size());
    visit(character);
  }
}

}  // namespace kanec
