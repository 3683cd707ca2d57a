// Oracle: sums whose cheapest form is known, with their number of additions.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/field.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;

int additions(const Program& program) { return ledger(program, program.functions[0]).adds; }

// The diagonal of a rotation matrix: 1 - yy - zz, 1 - xx - zz, 1 - xx - yy. Six additions, five when one is shared.
TEST(ShareSums, diagonal_of_a_rotation_shares_one_partial_sum) {
  SmallProgram b;
  const Ref xx = b.x(0), yy = b.x(1), zz = b.x(2), one = b.c(1);
  const auto less = [&](Ref u, Ref v) { return b.subtract(b.subtract(one, u), v); };
  const Program program = b.with({less(yy, zz), less(xx, zz), less(xx, yy)});
  const Program shared = share_sums(program);
  EXPECT_EQ(additions(program), 6);
  EXPECT_EQ(additions(shared), 5);
  EXPECT_EQ(test::values_at_random(shared), test::values_at_random(program));
}

TEST(ShareSums, a_partial_sum_is_found_in_any_order_and_with_the_opposite_sign) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1), w = b.x(2), z = b.x(3);
  // u + v + w, z - v - u
  const Program program = b.with({b.add(b.add(u, v), w), b.subtract(b.subtract(z, v), u)});
  const Program shared = share_sums(program);
  EXPECT_EQ(additions(program), 4);
  EXPECT_EQ(additions(shared), 3);
  EXPECT_EQ(test::values_at_random(shared), test::values_at_random(program));
}

TEST(ShareSums, three_common_terms_are_added_once) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1), w = b.x(2), z = b.x(3), p = b.p(0);
  const Program program =
      b.with({b.add(b.add(b.add(u, v), w), z), b.add(b.add(b.add(w, p), v), u)});  // u + v + w + z, w + p + v + u
  EXPECT_EQ(additions(program), 6);
  EXPECT_EQ(additions(share_sums(program)), 4);
}

TEST(ShareSums, a_named_sum_stays_one_operation_of_its_own) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1), w = b.x(2), z = b.x(3);
  const Ref named = b.add(u, v);
  // named + w, v + w + z: v + w would be shared if the name were dissolved
  const Program program = share_sums(b.with({b.add(named, w), b.add(b.add(v, w), z)}, {named}));
  EXPECT_EQ(additions(program), 4);
  const Ref kept = program.functions[0].quantities[0].entries[0];
  EXPECT_FALSE(kept.negative);
  EXPECT_TRUE(std::holds_alternative<Add>(node(program, kept)));
  const auto& sum = std::get<Add>(node(program, output(program)));
  EXPECT_TRUE(sum.a == kept.node || sum.b == kept.node);
}

TEST(ShareSums, a_sum_of_parameters_stays_with_the_parameters) {
  SmallProgram b;
  // x0 + (p0 + p1): one addition a call, one in prepare
  const Program program = b.with({b.add(b.x(0), b.add(b.p(0), b.p(1)))});
  const Program shared = share_sums(program);
  EXPECT_EQ(additions(shared), 1);
  EXPECT_EQ(prepare_ledger(shared).adds, 1);
}

TEST(ShareSums, a_term_that_stands_twice_stays_twice) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1);
  const Program program = b.with({b.add(b.add(u, v), u), b.subtract(b.add(v, u), b.x(2))});
  const Program shared = share_sums(program);
  EXPECT_EQ(test::values_at_random(shared), test::values_at_random(program));
  EXPECT_EQ(additions(shared), 3);
}

// Energy and momentum of hundreds of bodies are such sums. All pairs of their terms would be two hundred million.
TEST(ShareSums, a_sum_of_ten_thousands_of_terms_shares_the_few_that_another_has) {
  SmallProgram b;
  Ref all = b.x(0);
  std::vector<Ref> squares;
  for (Index i = 0; i < 20'000; ++i) {
    squares.push_back(b.multiply(b.x(i), b.x(i)));
    all = b.add(all, squares.back());
  }
  const Ref some = b.add(b.add(squares[700], squares[19'999]), b.x(3));
  const Program program = b.with({all, some});
  EXPECT_EQ(additions(program), 20'002);
  EXPECT_EQ(additions(share_sums(program)), 20'001);
}

}  // namespace
}  // namespace kanec::program
