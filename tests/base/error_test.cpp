// Messages are compared with texts written here by hand.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/error.hpp"

#include <gtest/gtest.h>

namespace kanec {
namespace {

TEST(Error, scene_fault_is_told_from_file_to_remedy) {
  const SceneError error(SceneFault{"arm.toml", 12, "body 3 (arm)", "mass", "-1", "a number above 0"});
  EXPECT_STREQ(error.what(), "arm.toml:12: body 3 (arm): mass: found -1; allowed: a number above 0");
  EXPECT_EQ(error.fault().line, 12);
  EXPECT_EQ(error.fault().field, "mass");
}

TEST(Error, unknown_parts_of_a_scene_fault_are_left_out) {
  EXPECT_STREQ(SceneError(SceneFault{"", 0, "", "connection", "2", ""}).what(), "connection: found 2");
  EXPECT_STREQ(SceneError(SceneFault{"a.toml", 0, "", "", "", "a table"}).what(), "a.toml; allowed: a table");
  EXPECT_STREQ(SceneError(SceneFault{"a.toml", 3, "", "gravity", "", ""}).what(), "a.toml:3: gravity");
}

TEST(Error, file_error_names_path_and_cause) {
  EXPECT_STREQ(FileError("out/a.csv", "No space left on device").what(), "out/a.csv: No space left on device");
}

TEST(Error, build_error_shows_command_and_output) {
  const BuildError error("the compiler failed", "c++ -O2 a.cpp", "a.cpp:1: error: x");
  EXPECT_STREQ(error.what(), "the compiler failed\n  command: c++ -O2 a.cpp\na.cpp:1: error: x");
  EXPECT_EQ(error.command(), "c++ -O2 a.cpp");
  EXPECT_EQ(error.output(), "a.cpp:1: error: x");
  EXPECT_STREQ(BuildError("no compiler", "", "").what(), "no compiler");
}

TEST(Error, message_is_one_line_whatever_stands_in_it) {
  EXPECT_STREQ(InputError("a\n\x1b[1m\u202e\xff").what(), "a\\x0a\\x1b[1m\\u202e\\xff");
  EXPECT_STREQ(FileError("a\nb", "gone").what(), "a\\x0ab: gone");
  const SceneError error(SceneFault{"a\n.toml", 1, "", "", "\"x\ny\"", "z"});
  EXPECT_STREQ(error.what(), "a\\x0a.toml:1: found \"x\\x0ay\"; allowed: z");
  EXPECT_EQ(error.fault().file, "a\n.toml");
}

TEST(Error, another_programs_words_keep_their_lines) {
  EXPECT_STREQ(BuildError("a\nb", "c\nd", "e\r\n\x1b").what(), "a\\x0ab\n  command: c\\x0ad\ne\n\\x1b");
  EXPECT_STREQ(FileError("a\nb", "gnuplot failed", "c\nd\x07").what(), "a\\x0ab: gnuplot failed\nc\nd\\x07");
}

TEST(Error, every_error_is_caught_as_the_base) {
  EXPECT_THROW(throw SceneError(SceneFault{}), Error);
  EXPECT_THROW(throw InputError(""), Error);
  EXPECT_THROW(throw FileError("", ""), Error);
  EXPECT_THROW(throw BuildError("", "", ""), Error);
  EXPECT_THROW(throw LoadError(""), Error);
  EXPECT_THROW(throw IntegrationError(""), Error);
  EXPECT_THROW(throw InternalError(""), Error);
}

}  // namespace
}  // namespace kanec
