// Arithmetic of blocks, entry by entry. Oracle: definitions of the operations, evaluated exactly in a prime field.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/lower/block.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "runtime/base/error.hpp"
#include "tests/program/field.hpp"

namespace kanec::lower {
namespace {

using program::Group;
using test::Field;
using test::Random;
using testing::ThrowsMessage;

// A 3×3 matrix or a vector of field elements, multiplied in the plainest way.
struct Plain {
  int rows, columns;
  std::vector<Field> entries;
  Field at(int i, int j = 0) const { return entries[static_cast<std::size_t>(i * columns + j)]; }
  bool operator==(const Plain&) const = default;
};

Plain operator*(const Plain& a, const Plain& b) {
  Plain result{a.rows, b.columns, {}};
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < b.columns; ++j) {
      Field sum(0.0);
      for (int k = 0; k < a.columns; ++k) sum = sum + a.at(i, k) * b.at(k, j);
      result.entries.push_back(sum);
    }
  return result;
}

Plain operator*(Field factor, Plain a) {
  for (Field& entry : a.entries) entry = factor * entry;
  return a;
}

Plain operator+(Plain a, const Plain& b) {
  for (std::size_t i = 0; i < a.entries.size(); ++i) a.entries[i] = a.entries[i] + b.entries[i];
  return a;
}

Plain cross_matrix(const Plain& a) {
  const Field zero(0.0);
  return {3, 3, {zero, -a.at(2), a.at(1), a.at(2), zero, -a.at(0), -a.at(1), a.at(0), zero}};
}

Plain transpose(const Plain& a) {
  Plain result{a.columns, a.rows, {}};
  for (int j = 0; j < a.columns; ++j)
    for (int i = 0; i < a.rows; ++i) result.entries.push_back(a.at(i, j));
  return result;
}

Plain identity() {
  const Field zero(0.0), one(1.0);
  return {3, 3, {one, zero, zero, zero, one, zero, zero, zero, one}};
}

class Blocks : public testing::Test {
 protected:
  Ref number() {
    arguments.x.push_back(Field::random(random));
    return b.variable(Group::x, static_cast<program::Index>(arguments.x.size()) - 1);
  }
  Block vector() {
    const Ref u = number(), v = number(), w = number();
    return lower::vector(u, v, w);
  }
  Block matrix() {
    Block m{3, 3, {}};
    for (int i = 0; i < 9; ++i) m.at(i / 3, i % 3) = number();
    return m;
  }
  Block symmetric() {
    Block m = matrix();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) m.at(i, j) = m.at(j, i);
    return m;
  }

  program::Program program(const Block& block) const {
    const std::vector<Ref> outputs(block.entries.begin(), block.entries.begin() + block.size());
    return {{}, b.nodes(), {{"f", "", {}, outputs, {}, block.size(), 0}}};
  }
  Plain value(const Block& block) const {
    const program::Program p = program(block);
    return {block.rows, block.columns, evaluate(p, p.functions[0], arguments)};
  }
  Field value(Ref ref) const { return value(scalar(ref)).at(0); }
  program::Ledger cost(const Block& block) const {
    const program::Program p = program::optimized(program(block));
    return program::ledger(p, p.functions[0]);
  }

  Builder b;
  Random random{5};
  program::Arguments<Field> arguments;
};

TEST_F(Blocks, sums_products_and_transposes_are_those_of_matrices) {
  const Block A = matrix(), B = matrix(), v = vector();
  EXPECT_EQ(value(add(b, A, -B)), value(A) + Field(-1.0) * value(B));
  EXPECT_EQ(value(multiply(b, A, B)), value(A) * value(B));
  EXPECT_EQ(value(multiply(b, A, v)), value(A) * value(v));
  EXPECT_EQ(value(multiply(b, transposed(v), A)), transpose(value(v)) * value(A));
  EXPECT_EQ(value(transposed(A)), transpose(value(A)));
  EXPECT_EQ(value(dot(b, v, multiply(b, A, v))), (transpose(value(v)) * value(A) * value(v)).at(0));
}

TEST_F(Blocks, a_scalar_scales_from_either_side_and_stands_for_a_multiple_of_the_identity_in_sums) {
  const Block A = matrix(), m = scalar(number());
  EXPECT_EQ(value(multiply(b, m, A)), value(m.at(0)) * value(A));
  EXPECT_EQ(value(multiply(b, A, m)), value(m.at(0)) * value(A));
  EXPECT_EQ(value(add(b, m, A)), value(m.at(0)) * identity() + value(A));
  EXPECT_EQ(value(add(b, A, m)), value(m.at(0)) * identity() + value(A));
}

TEST_F(Blocks, shapes_that_do_not_fit_are_refused) {
  EXPECT_THAT([&] { add(b, matrix(), vector()); }, ThrowsMessage<InternalError>("sum of blocks of different shape"));
  EXPECT_THAT([&] { add(b, vector(), scalar(number())); },
              ThrowsMessage<InternalError>("sum of blocks of different shape"));
  EXPECT_THAT([&] { multiply(b, vector(), matrix()); },
              ThrowsMessage<InternalError>("product of blocks whose shapes do not fit"));
}

TEST_F(Blocks, skew_is_the_matrix_of_the_cross_product) {
  const Block a = vector(), c = vector();
  const Plain u = value(a), v = value(c);
  const Plain expected{3,
                       1,
                       {u.at(1) * v.at(2) - u.at(2) * v.at(1), u.at(2) * v.at(0) - u.at(0) * v.at(2),
                        u.at(0) * v.at(1) - u.at(1) * v.at(0)}};
  EXPECT_EQ(value(multiply(b, skew(b, a), c)), expected);
}

TEST_F(Blocks, rotation_is_one_plus_twice_e_times_eps4_plus_e) {
  const Block e = vector(), eps4 = scalar(number());
  const Plain cross = cross_matrix(value(e));
  const Plain expected = identity() + Field(2.0) * (cross * (value(eps4.at(0)) * identity() + cross));
  EXPECT_EQ(value(rotation(b, e, eps4.at(0))), expected);
}

// Oracle for the cost: 3 doublings, 9 products, 11 sums where three of the diagonal share 1 - xx.
TEST_F(Blocks, rotation_takes_23_operations) {
  const Block e = vector();
  EXPECT_EQ(cost(rotation(b, e, number())), (program::Ledger{11, 12, 0, 0, 0}));
}

// The square of any quaternion over its squared norm has unit norm, in every field.
TEST_F(Blocks, rotation_of_unit_euler_parameters_is_orthonormal) {
  const Field x = Field::random(random), y = Field::random(random), z = Field::random(random),
              w = Field::random(random);
  const Field norm = x * x + y * y + z * z + w * w;
  const Field two(2.0);
  arguments.x = {two * w * x / norm, two * w * y / norm, two * w * z / norm, (w * w - x * x - y * y - z * z) / norm};
  const Ref e1 = b.variable(Group::x, 0), e2 = b.variable(Group::x, 1), e3 = b.variable(Group::x, 2);
  const Plain R = value(rotation(b, lower::vector(e1, e2, e3), b.variable(Group::x, 3)));
  EXPECT_EQ(R * transpose(R), identity());
  EXPECT_EQ(transpose(R) * R, identity());
}

// Of a random element t, ((1 − t²) / (1 + t²), 2t / (1 + t²)) lies on the unit circle in every field.
TEST_F(Blocks, congruence_and_similarity_by_a_plane_rotation_are_the_products_of_matrices) {
  for (int i = 0; i < 3; ++i) {
    const Field t = Field::random(random), norm = Field(1.0) + t * t;
    arguments.x = {(Field(1.0) - t * t) / norm, Field(2.0) * t / norm};
    const Ref c = b.variable(Group::x, 0), s = b.variable(Group::x, 1);
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Block C{3, 3, {}};
    C.entries.fill(b.constant(0.0));
    C.at(i, i) = b.constant(1.0);
    C.at(j, j) = C.at(k, k) = c;
    C.at(k, j) = s;
    C.at(j, k) = -s;
    const Block A = matrix(), J = symmetric();
    EXPECT_EQ(value(congruence(b, C, J)), value(C) * value(J) * transpose(value(C)));
    EXPECT_EQ(value(similarity(b, C, A)), value(C) * value(A) * transpose(value(C)));
    EXPECT_EQ(cost(congruence(b, C, J)).operations(), 15 + 1);  // and twice the cosine
  }
}

TEST_F(Blocks, congruence_by_any_rotation_is_the_product_of_matrices_and_takes_59_operations) {
  const Field x = Field::random(random), y = Field::random(random), z = Field::random(random),
              w = Field::random(random);
  const Field norm = x * x + y * y + z * z + w * w, two(2.0);
  arguments.x = {two * w * x / norm, two * w * y / norm, two * w * z / norm, (w * w - x * x - y * y - z * z) / norm};
  const Ref e1 = b.variable(Group::x, 0), e2 = b.variable(Group::x, 1), e3 = b.variable(Group::x, 2);
  const Block C = rotation(b, lower::vector(e1, e2, e3), b.variable(Group::x, 3)), J = symmetric();
  EXPECT_EQ(value(congruence(b, C, J)), value(C) * value(J) * transpose(value(C)));
  EXPECT_EQ(cost(congruence(b, matrix(), symmetric())).operations(), 59);
}

TEST_F(Blocks, ldl_solves_a_symmetric_system_with_three_divisions) {
  const Block A = symmetric(), B = matrix();
  const Block factors = ldl(b, A);
  const Block X = backward(b, factors, scaled(b, factors, forward(b, factors, B)));
  EXPECT_EQ(value(A) * value(X), value(B));
  EXPECT_EQ(cost(factors).divides, 3);
}

TEST_F(Blocks, outer_is_a_column_times_a_row) {
  const Block u = vector(), v = vector();
  EXPECT_EQ(value(outer(b, u, v)), value(u) * transpose(value(v)));
}

TEST_F(Blocks, turn_about_a_coordinate_axis_is_that_about_any_vector) {
  const Ref angle = number();
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      Block axis = lower::vector(b.constant(0.0), b.constant(0.0), b.constant(0.0));
      axis.at(i) = b.constant(sign);
      const Plain cross = cross_matrix(value(axis));
      const Field s = value(b.sine(angle)), c = value(b.cosine(angle));
      EXPECT_EQ(value(turn(b, axis, angle)), identity() + s * cross + (Field(1.0) + Field(-1.0) * c) * (cross * cross));
    }
}

TEST_F(Blocks, inverse_undoes_a_symmetric_matrix_with_one_division) {
  const Block A = symmetric();
  const Block inverted = inverse(b, A);
  EXPECT_EQ(value(inverted) * value(A), identity());
  EXPECT_EQ(value(inverted), transpose(value(inverted)));
  EXPECT_EQ(cost(inverted).divides, 1);
}

TEST_F(Blocks, gyroscopic_is_omega_cross_inertia_omega) {
  const Block I = symmetric(), omega = vector();
  EXPECT_EQ(value(gyroscopic(b, I, omega)), cross_matrix(value(omega)) * value(I) * value(omega));
}

TEST_F(Blocks, second_moment_is_half_the_trace_less_the_inertia) {
  const Block I = symmetric();
  const Field o(0.0), i(1.0);
  const Plain one{3, 3, {i, o, o, o, i, o, o, o, i}};
  const Plain inertia = value(I);
  const Field half_trace = Field(0.5) * (inertia.at(0, 0) + inertia.at(1, 1) + inertia.at(2, 2));
  EXPECT_EQ(value(second_moment(b, I)), half_trace * one + -Field(1.0) * inertia);
}

TEST_F(Blocks, inertia_moment_is_inertia_omegadot_plus_gyroscopic) {
  const Block I = symmetric(), omega = vector(), omegadot = vector();
  const Block spin = add(b, skew(b, omegadot), multiply(b, skew(b, omega), skew(b, omega)));
  const Plain cross = cross_matrix(value(omega));
  EXPECT_EQ(value(inertia_moment(b, spin, I)), value(I) * value(omegadot) + cross * value(I) * value(omega));
}

}  // namespace
}  // namespace kanec::lower
