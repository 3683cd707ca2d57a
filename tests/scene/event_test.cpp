// What [[event]] may say. Oracle: the rules of models/README.md.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;

// From line 9.
std::string event(const std::string& lines) {
  return "name = 'one'\nconnection = [0]\n[inputs]\npush = 1\n[[body]]\nmass = 1\ninertia = [1, 1, 1]\nforce = "
         "['push', "
         "0, 0]\n[[event]]\n" +
         lines + "\n";
}
const std::string zero = "name = 'zero'\nexpression = 's_1_1 - t'\n";

TEST(EventTable, has_defaults_and_its_expression) {
  const Scene scene = parse(event(zero), "f");
  ASSERT_EQ(scene.events.size(), 1u);
  const Event& found = scene.events[0];
  EXPECT_EQ(found.name, "zero");
  EXPECT_EQ(scene.expressions[static_cast<std::size_t>(found.expression.index)].text, "s_1_1 - t");
  EXPECT_EQ(found.direction, Event::Direction::both);
  EXPECT_EQ(found.action, Event::Action::record);
  EXPECT_FALSE(found.row);
}

TEST(EventTable, sets_inputs) {
  const Event found = parse(event(zero + "direction = 'down'\nset = {push = 2.5}\nrow = true"), "f").events[0];
  EXPECT_EQ(found.direction, Event::Direction::down);
  EXPECT_EQ(found.action, Event::Action::set);
  ASSERT_EQ(found.settings.size(), 1u);
  EXPECT_EQ(found.settings[0].input, 0);
  EXPECT_EQ(found.settings[0].value, 2.5);
  EXPECT_TRUE(found.row);
}

TEST(EventTable, refuses_what_never_happens_or_does_nothing) {
  EXPECT_THAT(
      message(event("name = 'a'\nexpression = 'push - 1'")),
      HasSubstr("f:11: event 1 (a): expression: found \"push - 1\", which no motion brings to zero; allowed: an "
                "expression of the time, coordinates or speeds"));
  EXPECT_THAT(message(event("name = 'a'\nexpression = 2.0")), HasSubstr("event 1 (a): expression: found 2"));
  EXPECT_THAT(message(event("name = 'a'\nexpression = 's_1_9'")), HasSubstr("f:11: event 1 (a): expression: "));
  EXPECT_THAT(message(event("expression = 't - 1'")), HasSubstr("event 1: name: "));
  EXPECT_THAT(message(event(zero + "direction = 'left'")),
              HasSubstr("f:12: event 1 (zero): direction: found the text \"left\"; allowed: both, up, down"));
  EXPECT_THAT(message(event(zero + "action = 'set'")), HasSubstr("found \"set\" without the inputs to be set"));
  EXPECT_THAT(message(event(zero + "action = 'stop'\nset = {push = 1}")), HasSubstr("found \"stop\" beside set"));
  EXPECT_THAT(message(event(zero + "set = {}")), HasSubstr("event 1 (zero): set: found an empty table"));
  EXPECT_THAT(message(event(zero + "set = {pull = 1}")),
              HasSubstr("found an unknown name; allowed: inputs of the scene: push"));
  EXPECT_THAT(message(event(zero + "row = 1")), HasSubstr("event 1 (zero): row: found 1; allowed: true or false"));
  EXPECT_THAT(message(event(zero + "[[event]]\n" + zero)),
              HasSubstr("f:13: event 2: name: found \"zero\", the name of another event"));
}

}  // namespace
}  // namespace kanec::scene
