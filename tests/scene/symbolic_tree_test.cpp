// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <set>

#include "generator/read/eigenvalues.hpp"
#include "runtime/base/text.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;

const std::vector<int> six = {0, 1, 2, 2, 1, 5};

std::vector<int> chain(int bodies) {
  std::vector<int> lower;
  for (int k = 0; k < bodies; ++k) lower.push_back(k);
  return lower;
}

std::string name_of(const Scene& scene, const Number& number) {
  const auto& list = number.kind == Number::Kind::parameter ? scene.parameters : scene.inputs;
  return list.at(static_cast<std::size_t>(number.index)).name;
}

TEST(SymbolicTree, is_named_after_its_array) {
  EXPECT_EQ(from_connection(six).name, "tree_012215");
  EXPECT_EQ(from_connection({0}).name, "tree_0");
}

TEST(SymbolicTree, name_tells_arrays_apart_whose_digits_run_together) {
  std::vector<int> eleven = chain(12), ones = chain(13);
  ones[11] = ones[12] = 1;  // …, 10, 1, 1 beside …, 10, 11
  EXPECT_EQ(from_connection(eleven).name, "tree_0_1_2_3_4_5_6_7_8_9_10_11");
  EXPECT_EQ(from_connection(ones).name, "tree_0_1_2_3_4_5_6_7_8_9_10_1_1");
}

TEST(SymbolicTree, name_of_many_bodies_is_a_fingerprint) {
  const std::string name = from_connection(chain(17)).name;
  EXPECT_THAT(name, testing::MatchesRegex("tree_17_[0-9a-f]+"));
  EXPECT_TRUE(is_identifier(name));
  std::vector<int> other = chain(17);
  other[16] = 0;
  EXPECT_NE(from_connection(other).name, name);
}

TEST(SymbolicTree, has_a_parameter_for_every_mass_inertia_r_q_and_gravity) {
  const Scene scene = from_connection(six);
  ASSERT_EQ(size(scene), 6);
  // 10 numbers a body and r; q for the five that stand on bodies; g
  EXPECT_EQ(scene.parameters.size(), 6u * (1 + 6 + 3) + 5u * 3 + 3);
  const Body& body = scene.bodies[2];
  EXPECT_EQ(name_of(scene, body.mass), "m_3");
  EXPECT_EQ(name_of(scene, body.inertia.xx), "I_3_xx");
  EXPECT_EQ(name_of(scene, body.inertia.yy), "I_3_yy");
  EXPECT_EQ(name_of(scene, body.inertia.zz), "I_3_zz");
  EXPECT_EQ(name_of(scene, body.inertia.xy), "I_3_xy");
  EXPECT_EQ(name_of(scene, body.inertia.xz), "I_3_xz");
  EXPECT_EQ(name_of(scene, body.inertia.yz), "I_3_yz");
  EXPECT_EQ(name_of(scene, body.r[0]), "r_3_1");
  EXPECT_EQ(name_of(scene, body.q[2]), "q_3_3");
  EXPECT_EQ(name_of(scene, scene.gravity[2]), "g_3");
}

TEST(SymbolicTree, has_an_input_for_every_load) {
  const Scene scene = from_connection(six);
  EXPECT_EQ(scene.inputs.size(), 36u);
  EXPECT_EQ(name_of(scene, scene.bodies[4].force[1]), "F_5_2");
  EXPECT_EQ(name_of(scene, scene.bodies[4].moment[2]), "M_5_3");
  for (const Body& body : scene.bodies) EXPECT_EQ(body.force[0].kind, Number::Kind::input);
}

TEST(SymbolicTree, has_no_joint_point_on_the_inertial_frame) {
  const Scene scene = from_connection({0, 1, 0});
  for (const Number& number : scene.bodies[0].q) EXPECT_TRUE(number.is_zero());
  for (const Number& number : scene.bodies[2].q) EXPECT_TRUE(number.is_zero());
  EXPECT_EQ(scene.bodies[1].q[0].kind, Number::Kind::parameter);
}

TEST(SymbolicTree, names_are_identifiers_and_each_its_own) {
  const Scene scene = from_connection(chain(512));
  std::set<std::string> names;
  for (const auto* list : {&scene.parameters, &scene.inputs})
    for (const Named& named : *list) {
      EXPECT_TRUE(is_identifier(named.name)) << named.name;
      EXPECT_TRUE(names.insert(named.name).second) << named.name;
    }
  EXPECT_EQ(names.size(), scene.parameters.size() + scene.inputs.size());
}

TEST(SymbolicTree, defaults_are_sound) {
  const Scene scene = from_connection(six);
  const auto value = [&](const Number& number) {
    return default_parameters(scene)[static_cast<std::size_t>(number.index)];
  };
  for (const Body& body : scene.bodies) {
    const Symmetric& i = body.inertia;
    const auto moments = eigenvalues({{{value(i.xx), value(i.xy), value(i.xz)},
                                       {value(i.xy), value(i.yy), value(i.yz)},
                                       {value(i.xz), value(i.yz), value(i.zz)}}});
    EXPECT_GT(value(body.mass), 0);
    EXPECT_GT(moments[0], 0);
    EXPECT_GT(moments[0] + moments[1], moments[2]);
    EXPECT_EQ(body.initial.eps, (std::array<double, 4>{0, 0, 0, 1}));
  }
  EXPECT_EQ(value(scene.gravity[2]), -9.81);
}

TEST(SymbolicTree, of_an_array_that_is_no_tree_is_refused) {
  const auto refused = [](const std::vector<int>& lower) -> std::string {
    try {
      from_connection(lower);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(refused({0, 2}), HasSubstr("connection array: number 2: found 2, so that body 2 stands on itself"));
  EXPECT_THAT(refused({}), HasSubstr("connection array: found no bodies"));
  EXPECT_THAT(refused(std::vector<int>(513, 0)), HasSubstr("found 513 bodies"));
}

}  // namespace
}  // namespace kanec::scene
