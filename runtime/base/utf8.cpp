// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/utf8.hpp"

namespace kanec {
namespace {

char32_t code(char c) { return static_cast<unsigned char>(c); }

// Of a sequence that begins with this byte; 0: none does.
std::size_t length(char32_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc0) return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf8 ? 4 : 0;
}

bool is_scalar_of(char32_t value, std::size_t size) {
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  return value >= least[size] && value <= 0x10ffff && !(value >= 0xd800 && value < 0xe000);
}

}  // namespace

Character first_character(std::string_view text) {
  const Character none{code(text[0]), text.substr(0, 1), false};
  const std::size_t size = length(none.value);
  if (size == 0 || size > text.size()) return none;
  char32_t value = size == 1 ? none.value : none.value & (0xffu >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((code(text[i]) & 0xc0) != 0x80) return none;
    value = value << 6 | (code(text[i]) & 0x3f);
  }
  if (!is_scalar_of(value, size)) return none;
  return {value, text.substr(0, size), true};
}

}  // namespace kanec
