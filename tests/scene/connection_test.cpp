// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;

TEST(Connection, array_with_a_forward_reference_is_refused) {
  EXPECT_EQ(
      message(tree("[0, 3, 1]", 3)),
      "f:2: connection[2]: found 3, a forward reference from body 2; allowed: a whole number from 0 (the inertial "
      "frame) to 1");
}

TEST(Connection, array_with_a_self_reference_is_refused) {
  EXPECT_EQ(
      message(tree("[0, 1, 3]", 3)),
      "f:2: connection[3]: found 3, so that body 3 stands on itself; allowed: a whole number from 0 (the inertial "
      "frame) to 2");
}

TEST(Connection, array_with_a_negative_number_is_refused) {
  EXPECT_EQ(message(tree("[0, -1]", 2)),
            "f:2: connection[2]: found -1; allowed: 0 (the inertial frame) or the number of a lower body");
}

TEST(Connection, array_without_a_body_on_the_inertial_frame_is_refused) {
  const std::string expected =
      "f:2: connection: found no body on the inertial frame; allowed: an array that begins with 0, the inertial frame";
  EXPECT_EQ(message(tree("[1, 1]", 2)), expected);
  EXPECT_EQ(message(tree("[1]", 1)), expected);
}

TEST(Connection, first_body_on_another_body_is_refused) {
  EXPECT_EQ(message(tree("[2, 0]", 2)),
            "f:2: connection[1]: found 2, a forward reference from body 1; allowed: 0, the inertial frame");
}

TEST(Connection, array_of_another_length_than_bodies_is_refused) {
  EXPECT_EQ(message(tree("[0, 1, 1]", 2)),
            "f:3: body: found 2 [[body]] tables; allowed: 3 [[body]] tables, one a number of connection");
  EXPECT_EQ(message(tree("[0]", 2)),
            "f:3: body: found 2 [[body]] tables; allowed: 1 [[body]] table, one a number of connection");
}

TEST(Connection, scene_without_bodies_is_refused) {
  EXPECT_EQ(message("name = 'none'\nconnection = []\n"),
            "f:2: connection: found no bodies; allowed: 1 to 512 numbers, one a body");
  EXPECT_EQ(message("name = 'none'\nconnection = [0]\nbody = []\n"),
            "f:3: body: found 0 [[body]] tables; allowed: 1 [[body]] table, one a number of connection");
}

TEST(Connection, entries_that_are_no_whole_numbers_are_refused) {
  const std::string allowed = "; allowed: a whole number, 0 (the inertial frame) or a lower body";
  EXPECT_EQ(message(tree("[0, 1.0]", 2)), "f:2: connection[2]: found 1.0" + allowed);
  EXPECT_EQ(message(tree("[0, 1.5]", 2)), "f:2: connection[2]: found 1.5" + allowed);
  EXPECT_EQ(message(tree("[0, '1']", 2)), "f:2: connection[2]: found the text \"1\"" + allowed);
  EXPECT_EQ(message(tree("[0, true]", 2)), "f:2: connection[2]: found true" + allowed);
  EXPECT_EQ(message(tree("[0, [1]]", 2)), "f:2: connection[2]: found a list of 1" + allowed);
  EXPECT_EQ(message(tree("[0, 9223372036854775807]", 2)), "f:2: connection[2]: found 9223372036854775807" + allowed);
}

TEST(Connection, other_values_than_lists_are_refused) {
  EXPECT_EQ(message(tree("0", 1)), "f:2: connection: found 0; allowed: a list of whole numbers, one a body");
  EXPECT_EQ(message(tree("'0,1'", 1)),
            "f:2: connection: found the text \"0,1\"; allowed: a list of whole numbers, one a body");
}

TEST(Connection, entry_on_a_line_of_its_own_is_named_by_that_line) {
  EXPECT_THAT(message(tree("[0,\n1,\n7]", 3)), HasSubstr("f:4: connection[3]: found 7"));
}

std::string chain(int bodies) {
  std::string text = "0";
  for (int k = 1; k < bodies; ++k) text.append(",").append(std::to_string(k));
  return text;
}

TEST(Connection, bodies_are_one_to_512) {
  const auto bracketed = [](const std::string& array) { return std::string("[").append(array).append("]"); };
  EXPECT_EQ(size(parse(tree(bracketed(chain(64)), 64), "f")), 64);
  EXPECT_EQ(message(tree(bracketed(chain(513)), 513)), "f:2: connection: found 513 bodies; allowed: 1 to 512");
}

TEST(Connection, forest_is_read) {
  EXPECT_EQ(parse(tree("[0, 0, 1, 2, 0]", 5), "f").lower, (std::vector<int>{0, 0, 1, 2, 0}));
}

std::string command_line(std::string_view text) {
  try {
    parse_connection(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ConnectionText, is_read_with_and_without_spaces) {
  const std::vector<int> expected = {0, 1, 2, 2, 1, 5};
  EXPECT_EQ(parse_connection("0,1,2,2,1,5"), expected);
  EXPECT_EQ(parse_connection(" 0, 1,\t2 ,2, 1, 5 "), expected);
  EXPECT_EQ(parse_connection("0"), std::vector<int>{0});
  EXPECT_EQ(parse_connection(chain(64)).size(), 64u);
}

TEST(ConnectionText, error_names_position_and_what_was_found) {
  const std::string allowed = "; allowed: a whole number from 0 (the inertial frame) to 1";
  EXPECT_EQ(command_line("0,x,1"), "--connection: number 2: found \"x\"" + allowed);
  EXPECT_EQ(command_line("0,,1"), "--connection: number 2: found nothing" + allowed);
  EXPECT_EQ(command_line("0,"), "--connection: number 2: found nothing" + allowed);
  EXPECT_EQ(command_line("0,1.5"), "--connection: number 2: found \"1.5\"" + allowed);
  EXPECT_EQ(command_line("0,1 1"), "--connection: number 2: found \"1 1\"" + allowed);
  EXPECT_EQ(command_line("0,+1"), "--connection: number 2: found \"+1\"" + allowed);
  EXPECT_EQ(command_line("0,99999999999"), "--connection: number 2: found \"99999999999\"" + allowed);
  EXPECT_EQ(command_line("0,2"), "--connection: number 2: found 2, so that body 2 stands on itself" + allowed);
  EXPECT_EQ(command_line("0,5"), "--connection: number 2: found 5, a forward reference from body 2" + allowed);
}

TEST(ConnectionText, array_that_is_no_tree_is_refused) {
  EXPECT_EQ(command_line(""), "--connection: found no bodies; allowed: 1 to 512 numbers, one a body");
  EXPECT_EQ(command_line("  "), "--connection: found no bodies; allowed: 1 to 512 numbers, one a body");
  EXPECT_EQ(command_line("0,-1"),
            "--connection: number 2: found -1; allowed: 0 (the inertial frame) or the number of a lower body");
  EXPECT_THAT(command_line("1,1"), HasSubstr("found no body on the inertial frame"));
  EXPECT_EQ(command_line(chain(513)), "--connection: found 513 bodies; allowed: 1 to 512");
}

TEST(ConnectionText, long_text_is_shown_by_its_beginning) {
  const std::string shown = command_line("0," + std::string(100000, 'x'));
  EXPECT_THAT(shown, HasSubstr("number 2: found \"" + std::string(40, 'x') + "\"… (100000 bytes)"));
  EXPECT_LT(shown.size(), 200u);
}

}  // namespace
}  // namespace kanec::scene
