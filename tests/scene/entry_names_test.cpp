// What entries of a state are called: by number, by body, and as they are printed.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/entry_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/read/read.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;

Scene bodies(const std::string& connection, const std::string& tables) {
  return parse("name = \"named\"\nconnection = " + connection + "\ngravity = [0, 0, 0]\n" + tables, "named.toml");
}

std::string hinge(const std::string& name) {
  return "[[body]]\n" + (name.empty() ? "" : "name = \"" + name + "\"\n") +
         "joint = \"revolute\"\naxis = \"y\"\nmass = 1\ninertia = [1, 1, 1]\nr = [1, 0, 0]\n";
}

std::string gimbal(const std::string& name) {
  return "[[body]]\nname = \"" + name +
         "\"\njoint = \"gimbal\"\naxes = [\"x\", \"y\", \"z\"]\nmass = 1\ninertia = [1, 1, 1]\n";
}

TEST(EntryNames, have_the_words_of_bodies_that_have_one) {
  const Scene scene = bodies("[0, 1, 2]", hinge("arm") + hinge("") + gimbal("hand"));
  EXPECT_THAT(body_words(scene), ElementsAre("arm", "2", "hand"));
  EXPECT_THAT(in_words(scene, coordinate_names(scene)),
              ElementsAre("theta_arm", "theta_2", "theta_hand_1", "theta_hand_2", "theta_hand_3"));
  EXPECT_EQ(in_words("omegadot_3_2", body_words(scene)), "omegadot_hand_2");
  EXPECT_EQ(in_words("R_1", body_words(scene)), "R_arm");
}

TEST(EntryNames, are_found_by_number_and_by_body) {
  const Scene scene = bodies("[0, 1, 2]", hinge("arm") + hinge("") + gimbal("hand"));
  const EntryNames names(scene);
  for (const char* name : {"thetadot_3_2", "thetadot_hand_2"}) {
    const auto entry = names.find(name);
    ASSERT_TRUE(entry) << name;
    EXPECT_EQ(entry->among, Entry::Among::y);
    EXPECT_EQ(entry->index, 3);
  }
  EXPECT_TRUE(names.find("theta_body_2"));
  EXPECT_FALSE(names.find("theta_hand"));
  EXPECT_FALSE(names.find("theta_4"));
  EXPECT_EQ(names.printed(Entry::Among::ydot)[0], "thetaddot_arm");
}

// theta_arm_2: the second angle of arm, or the one of arm_2. Neither is printed, nor taken.
TEST(EntryNames, of_two_meanings_are_none) {
  const Scene scene = bodies("[0, 1, 2]", gimbal("arm") + hinge("arm_2") + hinge("hand"));
  EXPECT_THAT(body_words(scene), ElementsAre("1", "2", "hand"));
  const EntryNames names(scene);
  EXPECT_FALSE(names.find("theta_arm_2"));
  EXPECT_TRUE(names.find("theta_2"));
  EXPECT_TRUE(names.find("theta_1_2"));
  const std::vector<std::string> printed = in_words(scene, coordinate_names(scene));
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const auto entry = names.find(printed[i]);
    ASSERT_TRUE(entry) << printed[i];
    EXPECT_EQ(entry->index, static_cast<int>(i));
  }
}

TEST(EntryNames, of_a_chain_of_hinges_alike_are_no_trouble) {
  EXPECT_THAT(body_words(bodies("[0, 1, 2]", hinge("leg") + hinge("leg_1") + hinge("leg_2"))),
              ElementsAre("leg", "leg_1", "leg_2"));
}

}  // namespace
}  // namespace kanec::scene
