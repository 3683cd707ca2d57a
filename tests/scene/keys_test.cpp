// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

TEST(Toml, text_that_is_not_toml_keeps_its_line) {
  EXPECT_THAT(message("name = 'a'\nconnection = [0\n\n[[body]"), StartsWith("f:4: found "));
  EXPECT_THAT(message("name = 'a'\nname = 'b'\n"), StartsWith("f:2: found "));
  EXPECT_THAT(message("\x7f\x45\x4c\x46"), StartsWith("f:1: found "));
  EXPECT_THAT(message("name = 'a'\nconnection: [0]\n"), HasSubstr("; allowed: TOML 1.0 (https://toml.io)"));
}

TEST(Toml, number_beyond_double_is_refused_with_its_line) {
  EXPECT_THAT(message(bare_body("mass = 1e400")), StartsWith("f:4: found "));
}

TEST(Toml, fault_carries_its_parts) {
  try {
    parse(one_body("q = [0, 0]"), "f");
    FAIL() << "no error";
  } catch (const SceneError& error) {
    EXPECT_EQ(error.fault().file, "f");
    EXPECT_EQ(error.fault().line, 6);
    EXPECT_EQ(error.fault().body, "body 1");
    EXPECT_EQ(error.fault().field, "q");
    EXPECT_EQ(error.fault().found, "a list of 2");
    EXPECT_EQ(error.fault().allowed, "a list of 3 numbers or names");
  }
}

TEST(Toml, deep_nesting_is_an_error_and_no_crash) {
  EXPECT_THAT(message("name = " + repeated("[", 100000)), StartsWith("f:1: found "));
  EXPECT_THAT(message("name = " + repeated("{a = ", 100000)), StartsWith("f:1: found "));
  const std::string dotted = "f:2: found a key of over 32 parts; allowed: keys of a few parts, as body.initial.eps";
  EXPECT_EQ(message("name = 'a'\n" + repeated("a.", 100000) + "a = 1\n"), dotted);
  EXPECT_EQ(message("name = 'a'\n[" + repeated("a . ", 100000) + "a]\n"), dotted);
  EXPECT_EQ(message("name = '''#\n'''\n" + repeated("'#'.", 100000) + "a = 1\n"),
            "f:3: found a key of over 32 parts; allowed: keys of a few parts, as body.initial.eps");
  EXPECT_EQ(message("x = {a = \"\"\"b\"\"\"\", \n" + repeated("\"\\\"=\".", 100000) + "a = 1}\n"),
            "f:2: found a key of over 32 parts; allowed: keys of a few parts, as body.initial.eps");
}

TEST(Toml, text_that_the_parser_asserts_against_is_an_error) {
  for (const std::string text : {"[\n", "[[\n", "[ #", "[=", "[.a]", "a = [0, }"})
    EXPECT_THAT(message("name = 'a'\n" + text), StartsWith("f:2: found Error while parsing ")) << text;
}

// Of the first three toml++ 3.3 has no defined behaviour.
TEST(Toml, letters_beyond_ascii_stand_in_quotes_and_comments_alone) {
  for (const std::string letter : {"\ufe7f", "\ufebf", "\ufefb", "\u00e9", "\ufeff"}) {
    const std::string shown = letter == "\ufeff" ? "\\ufeff" : letter;
    const std::string refusal =
        "found the character \"" + shown + "\"; allowed: ASCII outside of comments and texts in quotes";
    EXPECT_EQ(message(letter == "\ufeff" ? letter + letter : letter + "a = 1"), "f:1: " + refusal);
    EXPECT_EQ(message("name = 'a'\n  " + letter), "f:2: " + refusal);
    EXPECT_EQ(message("# " + letter + "\n" + one_body("")), "no error");
    EXPECT_THAT(message("name = \"\"\"" + letter + "\"\"\""), HasSubstr("f:1: name: found \"" + shown));
  }
  EXPECT_EQ(message("\ufeff" + one_body("")), "no error");
}

TEST(Toml, dots_in_comments_and_texts_are_no_nesting) {
  EXPECT_EQ(message("# " + repeated("0.1 ", 100) + "\n" + one_body("")), "no error");
  EXPECT_THAT(message(one_body("name = '" + repeated("a.", 100) + "'")), HasSubstr("body 1: name: found \"a.a."));
  EXPECT_THAT(message(one_body("r = [" + repeated("0.1,", 100) + "]")), HasSubstr("r: found a list of 100"));
}

TEST(Toml, huge_texts_are_shown_by_their_beginning) {
  EXPECT_EQ(
      message("name = '" + std::string(1000000, 'a') + "'\nconnection = [0]\n" + good_body()),
      "f:1: name: found \"" + std::string(40, 'a') +
          "\"… (1000000 bytes); allowed: a C++ identifier: letters, digits, single underscores, at most 63, a letter "
          "first, no keyword");
  EXPECT_LT(message(one_body(std::string(1000000, 'a') + " = 1")).size(), 300u);
}

TEST(Toml, message_cuts_no_character_in_two_and_escapes_controls) {
  EXPECT_THAT(message("name = \"" + std::string(39, 'a') + "ä\"\n"),
              HasSubstr("\"" + std::string(39, 'a') + "\"… (41 bytes)"));
  EXPECT_THAT(message("name = \"a\\n\\u001b\"\n"), HasSubstr(R"(found "a\x0a\x1b")"));
}

TEST(Keys, unknown_one_is_refused_with_the_nearest_at_every_level) {
  EXPECT_EQ(message("nam = 'a'\nconnection = [0]\n"),
            "f:1: nam: found an unknown key; allowed: name, connection, gravity, functions, parameters, inputs, body, "
            "point, load, event, simulate, ensemble (did you mean name?)");
  EXPECT_EQ(
      message(one_body("interia = 1")),
      "f:6: body 1: interia: found an unknown key; allowed: name, joint, frame_on_lower, mass, inertia, r, q, force, "
      "moment, initial, motion (did you mean inertia?)");
  EXPECT_EQ(message(one_body("[body.initial]\nomgea = 1")),
            "f:7: body 1: initial.omgea: found an unknown key; allowed: eps, omega, s, sdot (did you mean omega?)");
  EXPECT_EQ(message(with_table("[simulate]\nduratoin = 1")),
            "f:7: simulate.duratoin: found an unknown key; allowed: duration, output_step, integrator, step, "
            "relative_tolerance, absolute_tolerance, longest_step, jacobian, order (did you mean duration?)");
}

TEST(Keys, unknown_one_far_from_all_is_refused_without_a_guess) {
  EXPECT_EQ(message(one_body("[body.initial]\n'speed of light' = 1")),
            "f:7: body 1: initial.\"speed of light\": found an unknown key; allowed: eps, omega, s, sdot");
}

TEST(Keys, first_unknown_one_of_the_file_is_named) {
  EXPECT_THAT(message("zz = 1\naa = 1\n"), StartsWith("f:1: zz: "));
}

TEST(Keys, missing_one_is_refused) {
  EXPECT_EQ(message("connection = [0]\n" + good_body()),
            "f: name: found no such key, and it is required; allowed: the name of the scene");
  EXPECT_EQ(
      message("name = 'a'\n" + good_body()),
      "f: connection: found no such key, and it is required; allowed: the lower-numbered body array, as [0, 1, 2, 2, "
      "1, 5]");
  EXPECT_EQ(message("name = 'a'\nconnection = [0, 1]\n"),
            "f: body: found no such key, and it is required; allowed: 2 [[body]] tables, one a number of connection");
  EXPECT_EQ(
      message(bare_body("inertia = [1, 1, 1]")),
      "f:3: body 1: mass: found no such key, and it is required; allowed: a number or the name of a parameter [kg]");
  EXPECT_EQ(
      message(bare_body("name = 'arm'\nmass = 1")),
      "f:3: body 1 (arm): inertia: found no such key, and it is required; allowed: 3 principal moments, or 3 rows of 3 "
      "(about the mass centre, body axes)");
  EXPECT_THAT(message(""), StartsWith("f: name: found no such key"));
}

TEST(Keys, values_of_another_type_are_refused) {
  EXPECT_THAT(message("name = 1\n"), StartsWith("f:1: name: found 1; allowed: a C++ identifier"));
  EXPECT_EQ(message("name = 'a'\nconnection = [0]\nbody = 3\n"),
            "f:3: body: found 3; allowed: 1 [[body]] table, one a number of connection");
  EXPECT_EQ(message("name = 'a'\nconnection = [0]\n[body]\n"),
            "f:3: body: found a table; allowed: 1 [[body]] table, one a number of connection");
  EXPECT_EQ(message("name = 'a'\nconnection = [0]\nbody = [1]\n"), "f:3: body 1: found 1; allowed: a table");
  EXPECT_EQ(message(one_body("initial = [1]")), "f:6: body 1: initial: found a list of 1; allowed: a table");
  EXPECT_EQ(message("simulate = 1\n" + one_body("")), "f:1: simulate: found 1; allowed: a table");
  EXPECT_EQ(message("parameters = 'm'\n" + one_body("")), "f:1: parameters: found the text \"m\"; allowed: a table");
  EXPECT_EQ(message("inputs = []\n" + one_body("")), "f:1: inputs: found an empty list; allowed: a table");
  EXPECT_THAT(message(bare_body("mass = 1979-05-27\ninertia = [1, 1, 1]")),
              StartsWith("f:4: body 1: mass: found a date or time; "));
  EXPECT_THAT(message(bare_body("mass = false\ninertia = [1, 1, 1]")), StartsWith("f:4: body 1: mass: found false; "));
}

TEST(Keys, vectors_of_another_shape_are_refused) {
  for (const std::string key : {"r", "q", "force", "moment"}) {
    const bool load = key == "force" || key == "moment";
    const std::string shape = load ? "a list of 3 numbers, names or expressions" : "a list of 3 numbers or names";
    EXPECT_EQ(message(one_body(key + " = [1, 2]")), "f:6: body 1: " + key + ": found a list of 2; allowed: " + shape);
    EXPECT_EQ(message(one_body(key + " = 1")), "f:6: body 1: " + key + ": found 1; allowed: " + shape);
    EXPECT_THAT(message(one_body(key + " = [1, [2], 3]")),
                StartsWith("f:6: body 1: " + key + "[2]: found a list of 1; "));
  }
  EXPECT_EQ(message("gravity = []\n" + one_body("")),
            "f:1: gravity: found an empty list; allowed: a list of 3 numbers or names");
}

}  // namespace
}  // namespace kanec::scene
