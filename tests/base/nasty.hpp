// Text as a stranger may choose it: what ends lines, comments, quotes and words, or commands a terminal. Not: what is
// to become of it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::test {

// Each is a file name that a Linux system takes: neither a slash nor a NUL in them.
inline std::vector<std::string> nasty_names() {
  return {"\n#error x\n",
          "a\r#error x\r",
          "a\xe2\x80\xa8#error x",  // line separator
          "a\xc2\x85#error x",      // next line
          "'\"`",
          "back\\slash\\",
          "??",  // with the slash behind it a trigraph, a backslash
          "\xc3\xa9",
          "*",
          "$(touch touched)",
          "`touch touched`",
          "a;touch touched;",
          "a && touch touched & #",
          "'; touch touched; '",
          "\n!touch touched\n",
          "\nsystem('touch touched')\n",
          "\x1b[31mred\x1b]0;title\x07",
          "\xe2\x80\xaegnp.exe",  // right-to-left override
          "\xe2\x81\xa6isolate\xe2\x81\xa9\xe2\x80\x8f",
          "\xff\xfe\xc0\xaf\xed\xa0\x80",  // no UTF-8
          "a b  c\t",
          "-o",
          "~",
          "{{x}} $x$ %s %n #x [y](z) <b> & _u_ ^ | @",
          "![pic](x) ***",
          "\x7f\x01",
          "=1+2",
          "\xef\xbb\xbfmark"};
}

// And such as no file name can be.
inline std::vector<std::string> nasty_texts() {
  std::vector<std::string> list = nasty_names();
  for (const char* text : {"", "*/ int x; /*", "a//b", "?\?/", "?\?/\n", "/", "</text><script>", "\\"})
    list.emplace_back(text);
  list.emplace_back("nul\0nul", 7);
  return list;
}

}  // namespace kanec::test
