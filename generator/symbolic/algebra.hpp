// The block algebra that the derivation is written in: GiNaC expressions of non-commuting 3-vectors and 3×3 matrices.
// Not here: what the letters mean (equations.hpp) or how blocks become numbers (generator/lower).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <string>
#include <vector>

namespace kanec::symbolic {

enum class Shape { scalar, vector, matrix };

// A letter of the equations. Vectors and matrices do not commute; scalars do. `index` is the place in the SymbolTable.
class Atom : public GiNaC::symbol {
 public:
  Atom(const std::string& letter, const std::string& tex, Shape shape, int index)
      : GiNaC::symbol(letter, tex), shape_(shape), index_(index) {}
  Shape shape() const { return shape_; }
  int index() const { return index_; }

  unsigned return_type() const override {
    return shape_ == Shape::scalar ? GiNaC::return_types::commutative : GiNaC::return_types::noncommutative;
  }
  GiNaC::return_type_t return_type_tinfo() const override { return GiNaC::make_return_type_t<Atom>(); }
  Atom* duplicate() const override;

 private:
  Shape shape_;
  int index_;
};

// skew(a) b = a × b; linear in its argument.
DECLARE_FUNCTION_1P(skew)
// a·b of two vectors, a scalar.
DECLARE_FUNCTION_2P(dot)
// R_Kᵀ = 1 + 2 ẽ (ε4 + ẽ) of Euler parameters (e, ε4).
DECLARE_FUNCTION_2P(rotation)
// Inverse of a symmetric matrix.
DECLARE_FUNCTION_1P(inverse)
// Rotation by an angle about a unit vector, as (axis, angle): 1 + sin ã + (1 - cos) ã ã.
DECLARE_FUNCTION_2P(turn)
// C J Cᵀ of a symmetric J, as (C, J).
DECLARE_FUNCTION_2P(congruence)
// C A Cᵀ of any A, as (C, A).
DECLARE_FUNCTION_2P(similarity)
// a bᵀ of two vectors.
DECLARE_FUNCTION_2P(outer)
// L D Lᵀ of a symmetric matrix, in one: 1/D on the diagonal, L below it.
DECLARE_FUNCTION_1P(ldl)
// L⁻¹ B, D⁻¹ B and L⁻ᵀ B as (ldl, B).
DECLARE_FUNCTION_2P(forward)
DECLARE_FUNCTION_2P(scaled)
DECLARE_FUNCTION_2P(backward)
// Σ m r rᵀ = ½ tr(I) 1 − I of an inertia matrix I.
DECLARE_FUNCTION_1P(second_moment)
// An expression of the scene, as (index, order): its time derivative of that order.
DECLARE_FUNCTION_2P(expression)
// ω̃ I ω for a symmetric I, as (I, ω): its six products of speeds are shared with ω̃ω̃.
DECLARE_FUNCTION_2P(gyroscopic)
// I ω̇ + ω̃ I ω as (U, I) with U = ω̇~ + ω̃ω̃ and J = ½ tr(I) 1 − I: the axial vector of U J − (U J)ᵀ.
DECLARE_FUNCTION_2P(inertia_moment)

// An expanded expression is a sum of terms: a scalar times factors in order. No factors: a scalar, or that times the
// 3×3 identity where the sum is one of matrices.
struct Term {
  GiNaC::ex scalar;
  std::vector<GiNaC::ex> factors;
};

std::vector<Term> expanded(const GiNaC::ex& e);
GiNaC::ex product(const std::vector<GiNaC::ex>& factors);
GiNaC::ex sum(const std::vector<Term>& terms);

Shape shape_of(const GiNaC::ex& e);

// Transpose of a matrix expression; `of_atom` gives the transpose of a matrix letter.
GiNaC::ex transposed(const GiNaC::ex& e, const std::function<GiNaC::ex(const Atom&)>& of_atom);

// Time derivative by the product rule; `rate` gives the derivative of a letter.
GiNaC::ex time_derivative(const GiNaC::ex& e, const std::function<GiNaC::ex(const Atom&)>& rate);

// ∂e/∂y of a vector expression that is linear in the letter y: of a vector y the 3×3 factor that stands before it when
// ỹ b is written as −b̃ y, of a scalar y its coefficient. Throws InternalError where e is not linear in y.
GiNaC::ex partial(const GiNaC::ex& e, const GiNaC::ex& y);

}  // namespace kanec::symbolic
