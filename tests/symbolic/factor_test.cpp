// Oracle: the values of expressions as numbers and 3×3 matrices (alphabet.hpp), and forms known to be cheapest.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/factor.hpp"

#include <gtest/gtest.h>

#include "generator/symbolic/relative_rotations.hpp"
#include "tests/symbolic/alphabet.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;
using test::Random;

// Products of blocks, each 9 or 27 multiplications.
int block_products(const ex& e) {
  int n = GiNaC::is_a<GiNaC::ncmul>(e) ? static_cast<int>(e.nops()) - 1 : 0;
  for (const ex& operand : e) n += block_products(operand);
  return n;
}

class Factor : public testing::Test, protected Alphabet {};

TEST_F(Factor, common_factors_come_out_and_the_value_stays) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const ex e = symbolic::sum(expanded(sum(random, 2 + random.below(5), i % 2 == 0)));
    const ex f = factored(e);
    EXPECT_TRUE((symbolic::sum(expanded(f)) - e).expand().is_zero()) << e << "  ->  " << f;
    EXPECT_LE(block_products(f), block_products(e)) << e << "  ->  " << f;
  }
}

TEST_F(Factor, acceleration_of_a_point_takes_its_rotation_out_once) {
  // R ω̃ ω̃ d + R ω̇~ d + R s̈
  const ex e = R * skew(a) * skew(a) * b + R * skew(c) * b + R * c;
  EXPECT_TRUE(factored(e).is_equal(R * ((skew(a) * skew(a) + skew(c)) * b + c))) << factored(e);
}

TEST_F(Factor, a_sum_of_negative_terms_is_the_negative_of_a_sum) {
  EXPECT_TRUE(factored(-R * skew(a) - 2 * R * skew(b)).is_equal(-(R * (skew(a) + 2 * skew(b)))));
}

TEST_F(Factor, nothing_in_common_stays_as_it_is) {
  const ex e = R * a + A * b;
  EXPECT_TRUE(factored(e).is_equal(e));
}

TEST_F(Factor, a_rotation_and_its_transpose_side_by_side_are_one) {
  const auto simple = [this](const ex& e) { return with_relative_rotations(e, table); };
  EXPECT_TRUE(simple(R * Rt * b).is_equal(b));
  EXPECT_TRUE(simple(Rt * R * A + m * A * Qt * Q).is_equal(A + m * A));
  EXPECT_TRUE(simple(m * Qt * Q).is_equal(m));
  EXPECT_TRUE(simple(skew(a) * R * Q * Qt * Rt * b).is_equal(skew(a) * b));
  EXPECT_TRUE(simple(R * (Rt * a + Qt * b)).is_equal(a + R * Qt * b));
}

// E = R Q^T: what stands where two neighbours meet, also where one comes up only after another pair is gone.
TEST_F(Factor, neighbours_in_the_tree_become_the_rotation_of_their_joint) {
  JointRotations neighbours;
  neighbours.add(R, Qt, A);
  const auto simple = [&](const ex& e) { return with_relative_rotations(e, table, neighbours); };
  EXPECT_TRUE(simple(R * Qt * b).is_equal(A * b));
  EXPECT_TRUE(simple(m * R * Rt * R * Qt * skew(a)).is_equal(m * A * skew(a)));
  EXPECT_TRUE(simple(Q * Rt * b).is_equal(Q * Rt * b));
}

TEST_F(Factor, symmetric_matrices_and_separated_rotations_stay) {
  for (const ex& e : {ex(A * A * b), ex(R * A * Rt), ex(R * Qt * b), ex(R * R * b)})
    EXPECT_TRUE(with_relative_rotations(e, table).is_equal(e)) << e;
}

// What a body with hundreds of others on it sums: each of its groups has a factor of its own.
TEST_F(Factor, a_sum_of_hundreds_of_groups_takes_out_the_factor_of_each) {
  constexpr int groups = 300;
  ex e = 0;
  for (int i = 0; i < groups; ++i) {
    const auto letter = [&](const char* name) {
      return table.add(Role::quantity, name, name, std::to_string(i), Shape::vector);
    };
    const ex joint = letter("d");
    e += skew(joint) * letter("g") + skew(joint) * letter("h");
  }
  EXPECT_EQ(block_products(e), 2 * groups);
  EXPECT_EQ(block_products(factored(e)), groups);
}

}  // namespace
}  // namespace kanec::symbolic
