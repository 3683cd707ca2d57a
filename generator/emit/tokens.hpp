// Emitted code cut into tokens. Not: what they mean (check_code.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace kanec::emit {

enum class TokenKind { word, number, text, mark, end };  // a mark is one character, but for ::, -> and ==

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;
};

// Without comments, attributes, lines of the preprocessor and KANEC_CALL, which is empty; the last token is the end.
// Views into `code`.
std::vector<Token> tokens(std::string_view code);

}  // namespace kanec::emit
