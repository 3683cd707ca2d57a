// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/fit.hpp"

#include <algorithm>

#include "runtime/base/utf8.hpp"

namespace kanec::fit {
namespace {

bool is_between(char32_t c, char32_t first, char32_t last) { return c >= first && c <= last; }

bool is_control(char32_t c) { return c < 0x20 || is_between(c, 0x7f, 0x9f); }

// What a terminal, a browser or an editor does something for instead of showing it: controls, ends of lines and
// paragraphs, marks of direction, what has no width, and what is no character.
bool is_obeyed(char32_t c) {
  return is_control(c) || c == 0x61c || c == 0x180e || c == 0x200b || is_between(c, 0x200e, 0x200f) ||
         is_between(c, 0x2028, 0x202e) || is_between(c, 0x2060, 0x206f) || c == 0xfeff ||
         is_between(c, 0xfff9, 0xfffb) || is_between(c, 0xfffe, 0xffff);
}

bool is_shown(const Character& character) { return character.is_valid && !is_obeyed(character.value); }

bool is_letter_or_digit(char32_t c) {
  return is_between(c, '0', '9') || is_between(c, 'a', 'z') || is_between(c, 'A', 'Z');
}

bool is_one_of(std::string_view list, char32_t c) { return c < 0x80 && list.find(static_cast<char>(c)) != list.npos; }

// The last digits of a number, base 8 or 16.
std::string digits(char32_t value, unsigned bits, std::size_t count) {
  std::string text(count, '0');
  for (std::size_t i = count; i-- > 0; value >>= bits) text[i] = "0123456789abcdef"[value & ((1u << bits) - 1)];
  return text;
}

// "\u202e": nothing beyond U+FFFF is obeyed.
std::string with_u(char32_t c) { return "\\u" + digits(c, 4, 4); }

std::string escaped(const Character& character) {
  return character.value < 0x80 || !character.is_valid ? "\\x" + digits(character.value, 4, 2)
                                                       : with_u(character.value);
}

std::string with_octals(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += "\\" + digits(static_cast<unsigned char>(c), 3, 3);
  return text;
}

// Each of these characters behind a backslash.
std::string with_backslashes(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != special.npos) result += '\\';
    result += c;
  }
  return result;
}

bool is_plain(std::string_view text) {
  bool plain = true;
  for_characters(text, [&](const Character& character) { plain = plain && is_shown(character); });
  return plain;
}

const char* in_latex(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    case '`':
      return "`{}";
    default:
      return nullptr;
  }
}

const char* in_xml(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

// An underscore between letters or digits is no emphasis.
bool is_within_a_word(std::string_view text, std::size_t at) {
  const auto is_of_word = [](char c) { return is_letter_or_digit(static_cast<unsigned char>(c)); };
  return at > 0 && at + 1 < text.size() && is_of_word(text[at - 1]) && is_of_word(text[at + 1]);
}

// A shell takes NAME=... in front of a command for a setting.
bool is_bare(std::string_view word) {
  if (word.empty()) return false;
  const std::string_view more = is_one_of("-/.", static_cast<unsigned char>(word[0])) ? "_@%+:,./-=" : "_@%+:,./-";
  return std::all_of(word.begin(), word.end(), [more](char c) {
    return is_letter_or_digit(static_cast<unsigned char>(c)) || more.find(c) != more.npos;
  });
}

}  // namespace

std::string line(std::string_view text) {
  std::string result;
  for_characters(text, [&](const Character& character) {
    if (is_shown(character))
      result += character.bytes;
    else
      result += escaped(character);
  });
  return result;
}

std::string lines(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\n\t", begin), text.size());
    const bool has_return = end < text.size() && text[end] == '\n' && end > begin && text[end - 1] == '\r';
    result += line(text.substr(begin, end - begin - (has_return ? 1 : 0)));
    if (end < text.size()) result += text[end];
    begin = end + 1;
  }
  return result;
}

std::string comment(std::string_view text) {
  std::string result;
  for_characters(text, [&](const Character& character) {
    const char c = is_between(character.value, ' ', '~') ? character.bytes[0] : '_';
    const char before = result.empty() ? ' ' : result.back();
    const bool is_pair = (before == '?' && c == '?') || (before == '*' && c == '/') || (before == '/' && c == '*');
    result += c == '\\' || is_pair ? '_' : c;
  });
  return result;
}

std::string latex(std::string_view text) {
  std::string result;
  for (const char c : line(text)) {
    if (const char* replaced = in_latex(c))
      result += replaced;
    else
      result.append(std::string_view("#$%&_{}").find(c) == std::string_view::npos ? "" : "\\").append(1, c);
  }
  return result;
}

std::string gnuplot(std::string_view text) {
  // a doubled quote is one within single quotes, but for gnuplot 5.4 not at their beginning
  if (is_plain(text) && text.find('\'') == text.npos) return "'" + std::string(text) + "'";
  std::string result = "\"";
  for_characters(text, [&](const Character& character) {
    const bool is_safe = is_shown(character) && !is_one_of("\"'\\`", character.value);
    result += is_safe ? std::string(character.bytes) : with_octals(character.bytes);
  });
  return result + "\"";
}

std::string xml(std::string_view text) {
  std::string result;
  for (const char c : line(text)) {
    if (const char* replaced = in_xml(c))
      result += replaced;
    else
      result += c;
  }
  return result;
}

std::string markdown(std::string_view text) {
  const std::string shown = line(text);
  std::string result;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool is_special = std::string_view("\\`*[]<>&|~$").find(shown[i]) != std::string_view::npos ||
                            (shown[i] == '_' && !is_within_a_word(shown, i)) ||
                            (i == 0 && std::string_view("#+-").find(shown[i]) != std::string_view::npos);
    result.append(is_special ? "\\" : "").append(1, shown[i]);
  }
  return result;
}

std::string code(std::string_view text) {
  const std::string shown = line(text);
  std::size_t longest = 0, run = 0;
  for (const char c : shown) longest = std::max(longest, run = c == '`' ? run + 1 : 0);
  const std::string fence(longest + 1, '`'), gap = longest > 0 ? " " : "";
  return fence + gap + shown + gap + fence;
}

std::string link(std::string_view path) {
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_letter_or_digit(byte) || is_one_of("-_.~/", byte))
      result += c;
    else
      result += "%" + digits(byte, 4, 2);
  }
  return result;
}

std::string shell(std::string_view word) {
  if (is_bare(word)) return std::string(word);
  if (is_plain(word)) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }
  std::string result = "$'";
  for_characters(word, [&](const Character& character) {
    const bool is_safe = is_shown(character) && !is_one_of("'\\!", character.value);
    result += is_safe ? std::string(character.bytes) : with_octals(character.bytes);
  });
  return result + "'";
}

std::string csv(std::string_view field) {
  const std::string shown = line(field);
  if (shown.find_first_of(",\"") == std::string::npos) return shown;
  std::string result = "\"";
  for (const char c : shown) result.append(c == '"' ? 2 : 1, c);
  return result + "\"";
}

std::string json(std::string_view text) {
  std::string result;
  for_characters(text, [&](const Character& character) {
    if (character.value < 0x7f || is_shown(character))
      result += character.bytes;
    else
      result += with_u(character.is_valid ? character.value : 0xfffd);
  });
  return result;
}

std::string toml(std::string_view text) {
  std::string result = "\"";
  for_characters(text, [&](const Character& character) {
    if (is_shown(character))
      result += with_backslashes(character.bytes, "\"\\");
    else
      result += with_u(character.is_valid ? character.value : 0xfffd);
  });
  return result + "\"";
}

}  // namespace kanec::fit
