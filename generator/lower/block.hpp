// Scalars, 3-vectors and 3×3 matrices of program results, and their arithmetic entry by entry. Zeros and ones are left
// to the passes. Not: GiNaC.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "generator/program/builder.hpp"

namespace kanec::lower {

using program::Builder;
using program::Ref;

// Row-major; a vector is one column.
struct Block {
  int rows = 1;
  int columns = 1;
  std::array<Ref, 9> entries{};

  Ref& at(int i, int j = 0) { return entries[static_cast<std::size_t>(i * columns + j)]; }
  Ref at(int i, int j = 0) const { return entries[static_cast<std::size_t>(i * columns + j)]; }
  int size() const { return rows * columns; }
  bool is_scalar() const { return size() == 1; }
};

Block scalar(Ref value);
Block vector(Ref a, Ref b, Ref c);
Block operator-(const Block& a);
Block transposed(const Block& a);

// Sums in which a scalar stands for that times the identity where the others are matrices.
Block add(Builder& builder, const Block& a, const Block& b);
// Matrix product, or scaling where one of the two is a scalar.
Block multiply(Builder& builder, const Block& a, const Block& b);
Block skew(Builder& builder, const Block& a);
Ref dot(Builder& builder, const Block& a, const Block& b);

// R_Kᵀ of Euler parameters (e, ε4) of unit norm: 23 operations.
Block rotation(Builder& builder, const Block& e, Ref eps4);
// 1 + sin ã + (1 − cos) ã ã; of a coordinate axis a plane rotation.
Block turn(Builder& builder, const Block& axis, Ref angle);
// C J Cᵀ of a symmetric J: six entries, the other three by symmetry. Of a rotation C: the last entry is what
// the trace leaves, 59 operations instead of 75; a plane one goes through the double angle, 15 and twice the cosine.
Block congruence(Builder& builder, const Block& C, const Block& J);
// C A Cᵀ of any A; a plane rotation likewise.
Block similarity(Builder& builder, const Block& C, const Block& A);
// L D Lᵀ of a symmetric matrix: 1/D on the diagonal, L below it.
Block ldl(Builder& builder, const Block& symmetric);
// L⁻¹ B, D⁻¹ B and L⁻ᵀ B with what ldl returned; B a vector or a matrix.
Block forward(Builder& builder, const Block& factors, Block B);
Block scaled(Builder& builder, const Block& factors, Block B);
Block backward(Builder& builder, const Block& factors, Block B);
// a bᵀ of two vectors.
Block outer(Builder& builder, const Block& a, const Block& b);
// Inverse of a symmetric matrix through its cofactors.
Block inverse(Builder& builder, const Block& symmetric);
// ½ tr(I) 1 − I.
Block second_moment(Builder& builder, const Block& inertia);
// ω × I ω by the products of speeds, which ω̃ω̃ shares.
Block gyroscopic(Builder& builder, const Block& inertia, const Block& omega);
// I ω̇ + ω × I ω as the axial vector of U J − (U J)ᵀ, J = ½ tr(I) 1 − I.
Block inertia_moment(Builder& builder, const Block& spin, const Block& inertia);

}  // namespace kanec::lower
