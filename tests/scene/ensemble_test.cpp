// What [ensemble] may say. Oracle: the rules of models/README.md.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;

std::string ensemble(const std::string& lines) { return with_table("[ensemble]\n" + lines); }

TEST(EnsembleTable, is_none_where_it_is_not_written) { EXPECT_EQ(parse(with_table(""), "f").ensemble.count, 0); }

TEST(EnsembleTable, keeps_names_in_the_order_of_the_file) {
  const Ensemble found = parse(
                             "name = 'n'\nconnection = [0]\n[parameters]\nm = 2\n[inputs]\npush = 1\n[[body]]\nmass = "
                             "'m'\ninertia = [1, 1, 1]\nforce = ['push', 0, 0]\n[ensemble]\nseed = 5\npush = {normal = "
                             "[0, 2]}\nm = {uniform = [1, 3]}\ncount = 7\ns_1_2 = {uniform = [-1, -1]}\n",
                             "f")
                             .ensemble;
  EXPECT_EQ(found.count, 7);
  EXPECT_EQ(found.seed, 5);
  ASSERT_EQ(found.draws.size(), 3u);
  EXPECT_EQ(found.draws[0].name, "push");
  EXPECT_EQ(found.draws[0].kind, Draw::Kind::normal);
  EXPECT_EQ(found.draws[0].b, 2.0);
  EXPECT_EQ(found.draws[1].name, "m");
  EXPECT_EQ(found.draws[1].kind, Draw::Kind::uniform);
  EXPECT_EQ(found.draws[1].a, 1.0);
  EXPECT_EQ(found.draws[2].name, "s_1_2");
}

TEST(EnsembleTable, refuses_what_no_scenario_can_have) {
  EXPECT_THAT(message(ensemble("s_1_4 = {uniform = [0, 1]}")),
              HasSubstr("f:7: ensemble.s_1_4: found an unknown name; allowed: count, seed, or a coordinate, speed, "
                        "parameter or input: eps_1_1, "));
  EXPECT_EQ(message(ensemble("count = 0")), "f:7: ensemble.count: found 0; allowed: a whole number from 1 to 10000000");
  EXPECT_EQ(message(ensemble("count = 2.5")),
            "f:7: ensemble.count: found 2.5; allowed: a whole number from 1 to 10000000");
  EXPECT_EQ(message(ensemble("seed = -1")),
            "f:7: ensemble.seed: found -1; allowed: a whole number from 0 to 2147483647");
  EXPECT_EQ(message(ensemble("s_1_1 = 3")), "f:7: ensemble.s_1_1: found 3; allowed: a table");
  EXPECT_EQ(message(ensemble("s_1_1 = {}")),
            "f:7: ensemble.s_1_1: found a table; allowed: {uniform = [least, largest]} or {normal = [mean, standard "
            "deviation]}");
  EXPECT_EQ(message(ensemble("s_1_1 = {unifrom = [0, 1]}")),
            "f:7: ensemble.s_1_1.unifrom: found an unknown key; allowed: uniform, normal (did you mean uniform?)");
  EXPECT_EQ(message(ensemble("s_1_1 = {uniform = [1, 0]}")),
            "f:7: ensemble.s_1_1.uniform: found a least value above the largest; allowed: [least, largest]");
  EXPECT_EQ(message(ensemble("s_1_1 = {normal = [1, -2]}")),
            "f:7: ensemble.s_1_1.normal: found a negative standard deviation; allowed: [mean, standard deviation]");
  EXPECT_EQ(message(ensemble("s_1_1 = {normal = [1]}")),
            "f:7: ensemble.s_1_1.normal: found a list of 1; allowed: a list of 2 numbers");
}

}  // namespace
}  // namespace kanec::scene
