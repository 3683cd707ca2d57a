// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/letters.hpp"

#include <algorithm>
#include <cstddef>

namespace kanec::emit {
namespace {

constexpr char digits[] = "0123456789";

bool is_letter(char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lettered(const std::string& text, const Letters& letters, bool only_first) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_of(digits, at);
    if (begin == std::string::npos) return result + text.substr(at);
    const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
    const std::string number = text.substr(begin, end - begin);
    const bool is_body = begin > 0 && is_letter(text[begin - 1]) && number.size() < 7;
    const auto letter = is_body ? letters.find(std::stoi(number)) : letters.end();
    result += text.substr(at, begin - at) + (letter == letters.end() ? number : letter->second);
    at = end;
    if (is_body && only_first) return result + text.substr(at);
  }
  return result;
}

}  // namespace

std::string lettered_name(const std::string& name, const Letters& letters) { return lettered(name, letters, true); }

std::string lettered_equation(const std::string& equation, const Letters& letters) {
  return lettered(equation, letters, false);
}

}  // namespace kanec::emit
