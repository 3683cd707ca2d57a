// Oracle: the table of well-formed byte sequences (Unicode 15, table 3-7), written out by hand.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/utf8.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace kanec {
namespace {

TEST(Utf8, characters_of_every_length_are_read) {
  for (const auto& [text, value] : std::vector<std::pair<std::string, char32_t>>{{"a", 'a'},
                                                                                 {"\x7f", 0x7f},
                                                                                 {"\xc2\x80", 0x80},
                                                                                 {"\xdf\xbf", 0x7ff},
                                                                                 {"\xe0\xa0\x80", 0x800},
                                                                                 {"\xed\x9f\xbf", 0xd7ff},
                                                                                 {"\xee\x80\x80", 0xe000},
                                                                                 {"\xef\xbf\xbf", 0xffff},
                                                                                 {"\xf0\x90\x80\x80", 0x10000},
                                                                                 {"\xf4\x8f\xbf\xbf", 0x10ffff}}) {
    const Character character = first_character(text);
    EXPECT_TRUE(character.is_valid);
    EXPECT_EQ(character.value, value);
    EXPECT_EQ(character.bytes, text);
  }
}

TEST(Utf8, a_byte_with_which_no_character_begins_stands_alone) {
  for (const std::string text :
       {"\x80", "\xbf", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
        "\xf5\x80\x80\x80", "\xff", "\xc3", "\xe2\x80", "\xc3(", "\xe2\x28\xa1"}) {
    const Character character = first_character(text);
    EXPECT_FALSE(character.is_valid) << text;
    EXPECT_EQ(character.bytes, text.substr(0, 1));
  }
}

TEST(Utf8, every_byte_is_of_one_character) {
  const std::string text = "a\xff\xe2\x80\xa8\xe2\x80z";
  std::string together;
  int count = 0;
  for_characters(text, [&](const Character& character) {
    together += character.bytes;
    ++count;
  });
  EXPECT_EQ(together, text);
  EXPECT_EQ(count, 6);
}

}  // namespace
}  // namespace kanec
