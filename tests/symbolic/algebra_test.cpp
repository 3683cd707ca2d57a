// Oracle: the values of expressions as numbers and 3×3 matrices (alphabet.hpp), rates by dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/algebra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/error.hpp"
#include "tests/symbolic/alphabet.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;
using test::Random;
using testing::ThrowsMessage;

// A few hundred products and sums of numbers near 1 that may cancel to a tenth.
constexpr double tolerance = 1e-12;
constexpr int n_samples = 200;

class Algebra : public testing::Test, protected Alphabet {
 protected:
  Random random{1};
  Values values{table, random};

  double difference(const ex& left, const ex& right) const {
    return symbolic::difference(values.of(left), values.of(right));
  }
};

TEST_F(Algebra, skew_is_linear_and_equal_blocks_are_equal_expressions) {
  EXPECT_TRUE(ex(skew(2 * a - m * b)).is_equal(2 * skew(a) - m * skew(b)));
  EXPECT_TRUE(ex(skew(a - a)).is_zero());
  EXPECT_TRUE(ex(skew(A * (a + b))).is_equal(skew(A * b) + skew(A * a)));
  EXPECT_LT(difference(skew(a) * b, -skew(b) * a), tolerance);
}

TEST_F(Algebra, expanding_keeps_the_value_and_leaves_no_sum_inside_a_product) {
  for (int i = 0; i < n_samples; ++i) {
    const ex e = sum(random, 2, false) * sum(random, 3, true);
    EXPECT_LT(difference(symbolic::sum(expanded(e)), e), tolerance) << e;
    for (const Term& term : expanded(e))
      for (const ex& factor : term.factors) EXPECT_FALSE(GiNaC::is_a<GiNaC::add>(factor)) << e;
  }
}

TEST_F(Algebra, factors_keep_their_order) {
  const std::vector<Term> terms = expanded(R * skew(a) * (m * A) * b);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_TRUE(terms[0].scalar.is_equal(m));
  ASSERT_EQ(terms[0].factors.size(), 4u);
  EXPECT_TRUE(terms[0].factors[0].is_equal(R));
  EXPECT_TRUE(terms[0].factors[1].is_equal(skew(a)));
  EXPECT_TRUE(terms[0].factors[2].is_equal(A));
  EXPECT_TRUE(terms[0].factors[3].is_equal(b));
}

TEST_F(Algebra, transpose_has_the_transposed_value) {
  for (int i = 0; i < n_samples; ++i) {
    const ex e = sum(random, 3, false);
    const ex t = table.transposed(e);
    EXPECT_LT(symbolic::difference(values.of(t), Value(values.of(e).transpose())), tolerance) << e;
    EXPECT_TRUE(table.transposed(t).is_equal(symbolic::sum(expanded(e)))) << e;
  }
  EXPECT_TRUE(table.transposed(R * skew(a) * A).is_equal(-A * skew(a) * Rt));
  EXPECT_TRUE(table.transposed(inverse(A)).is_equal(inverse(A)));
  EXPECT_THROW(table.transposed(rotation(a, m)), InternalError);
}

TEST_F(Algebra, partial_derivative_times_the_letter_is_what_depends_on_the_letter) {
  for (int i = 0; i < n_samples; ++i) {
    // linear in c: c itself or c~ somewhere in each of some terms
    ex with_c = 0;
    ex before = 1;
    for (int j = 0; j < 3; ++j) {
      before = before * factor(random).subs(c == a, GiNaC::subs_options::no_pattern);
      with_c += random.chance(0.5) ? m * before * c : before * skew(c) * Rt * b;
    }
    const ex without_c = sum(random, 2, true).subs(c == b, GiNaC::subs_options::no_pattern);
    EXPECT_LT(difference(partial(with_c + without_c, c) * c, with_c), tolerance) << with_c;
  }
  EXPECT_TRUE(partial(R * skew(a) * b, a).is_equal(-R * skew(b)));
  EXPECT_TRUE(partial(R * a, a).is_equal(R));
  EXPECT_TRUE(partial(a, a).is_equal(1));
  EXPECT_TRUE(partial(R * b, a).is_zero());
}

TEST_F(Algebra, partial_derivative_of_what_is_not_linear_is_refused) {
  const char* message = "partial derivative of an expression that is not linear";
  for (const ex& e : {ex(skew(a) * skew(a) * b), ex(skew(a) * a), ex(R * skew(a)), ex(skew(R * a) * b),
                      ex(R * b + skew(a) * skew(b) * a)})
    EXPECT_THAT([&] { partial(e, a); }, ThrowsMessage<InternalError>(message)) << e;
}

TEST_F(Algebra, time_derivative_is_the_rate_of_the_value) {
  // every letter's rate is another letter, whose value is set to the rate of the first
  std::vector<ex> rates;
  const std::size_t n_letters = table.all().size();
  for (std::size_t i = 0; i < n_letters; ++i) {
    const ex letter = table.all()[i].atom;
    rates.push_back(table.add(Role::quantity, "rate", "", "", GiNaC::ex_to<Atom>(letter).shape()));
    Value value = values.of(letter);
    for (Eigen::Index j = 0; j < value.size(); ++j) value(j) = Real(value(j).rate);
    values.set(rates.back(), value);
  }
  const auto rate = [&](const Atom& atom) { return rates[static_cast<std::size_t>(atom.index())]; };
  for (int i = 0; i < n_samples; ++i) {
    // without powers of scalars, which equations of motion do not have
    const GiNaC::lst numbers = {m == 2, n == 3};
    const ex e = random.chance(0.5) ? sum(random, 3, true) : sum(random, 2, false).subs(numbers) * sum(random, 2, true);
    const Value derived = values.of(time_derivative(e, rate));
    EXPECT_LT(symbolic::difference(test::rates(Value(values.of(e))),
                                   derived.unaryExpr([](const Real& r) { return r.value; })),
              tolerance)
        << e;
  }
}

TEST_F(Algebra, time_derivative_of_constants_is_zero_and_of_a_function_of_them_refused) {
  const auto at_rest = [](const Atom&) { return ex(0); };
  EXPECT_TRUE(time_derivative(m * R * skew(a) * b + 3 * c, at_rest).is_zero());
  EXPECT_THAT([&] { time_derivative(rotation(a, m), at_rest); },
              ThrowsMessage<InternalError>("time derivative of a function that has none"));
}

TEST_F(Algebra, shapes_follow_from_the_factors) {
  for (const ex& e : {m, ex(2 * m), ex(dot(a, b)), m / n}) EXPECT_EQ(shape_of(e), Shape::scalar) << e;
  for (const ex& e : {a, ex(m * a), ex(R * a), ex(a + b), ex(m * (R * a + b)), ex(gyroscopic(A, a))})
    EXPECT_EQ(shape_of(e), Shape::vector) << e;
  for (const ex& e : {R, ex(skew(a)), ex(m * skew(a) * R), ex(A + skew(a)), ex(inverse(A))})
    EXPECT_EQ(shape_of(e), Shape::matrix) << e;
}

}  // namespace
}  // namespace kanec::symbolic
