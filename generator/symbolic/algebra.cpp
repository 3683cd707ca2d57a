// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/algebra.hpp"

#include <utility>

#include "runtime/base/error.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

const GiNaC::return_type_t& block_type() {
  static const GiNaC::return_type_t type = GiNaC::make_return_type_t<Atom>();
  return type;
}

// skew is linear: sums are distributed and scalars pulled out, so that equal blocks are equal expressions.
ex skew_eval(const ex& a) {
  if (a.is_zero()) return 0;
  const std::vector<Term> terms = expanded(a);
  const bool plain = terms.size() == 1 && terms[0].scalar.is_equal(1);
  if (plain) return skew(a).hold();
  ex result = 0;
  for (const Term& term : terms) result += term.scalar * skew(product(term.factors));
  return result;
}

ex second_moment_eval(const ex& I) { return I.is_zero() ? ex(0) : second_moment(I).hold(); }
// Of functions that are linear in both arguments, or in the second.
ex dot_eval(const ex& a, const ex& b) { return a.is_zero() || b.is_zero() ? ex(0) : dot(a, b).hold(); }
ex outer_eval(const ex& a, const ex& b) { return a.is_zero() || b.is_zero() ? ex(0) : outer(a, b).hold(); }
ex forward_eval(const ex& factors, const ex& b) { return b.is_zero() ? ex(0) : forward(factors, b).hold(); }
ex scaled_eval(const ex& factors, const ex& b) { return b.is_zero() ? ex(0) : scaled(factors, b).hold(); }
ex backward_eval(const ex& factors, const ex& b) { return b.is_zero() ? ex(0) : backward(factors, b).hold(); }
// C 1 Cᵀ where there is no turn.
ex congruence_eval(const ex& C, const ex& A) { return A.is_zero() || C.is_equal(1) ? A : congruence(C, A).hold(); }
ex similarity_eval(const ex& C, const ex& A) { return A.is_zero() || C.is_equal(1) ? A : similarity(C, A).hold(); }

}  // namespace

Atom* Atom::duplicate() const {
  Atom* copy = new Atom(*this);
  copy->setflag(GiNaC::status_flags::dynallocated);
  return copy;
}

REGISTER_FUNCTION(skew, eval_func(skew_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(dot, eval_func(dot_eval).set_return_type(GiNaC::return_types::commutative))
REGISTER_FUNCTION(rotation, set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(second_moment,
                  eval_func(second_moment_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(inverse, set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(turn, set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(congruence,
                  eval_func(congruence_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(similarity,
                  eval_func(similarity_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(outer, eval_func(outer_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(ldl, set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(forward, eval_func(forward_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(scaled, eval_func(scaled_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(backward,
                  eval_func(backward_eval).set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(expression, set_return_type(GiNaC::return_types::commutative))
REGISTER_FUNCTION(gyroscopic, set_return_type(GiNaC::return_types::noncommutative, &block_type()))
REGISTER_FUNCTION(inertia_moment, set_return_type(GiNaC::return_types::noncommutative, &block_type()))

std::vector<Term> expanded(const ex& e) {
  std::vector<Term> result;
  if (GiNaC::is_a<GiNaC::add>(e)) {
    for (const ex& operand : e)
      for (Term& term : expanded(operand)) result.push_back(std::move(term));
    return result;
  }
  if (e.return_type() == GiNaC::return_types::commutative) return {{e, {}}};
  if (!GiNaC::is_a<GiNaC::mul>(e) && !GiNaC::is_a<GiNaC::ncmul>(e)) return {{1, {e}}};
  result = {{1, {}}};
  for (const ex& operand : e) {
    std::vector<Term> next;
    for (const Term& left : result)
      for (const Term& right : expanded(operand)) {
        next.push_back({left.scalar * right.scalar, left.factors});
        next.back().factors.insert(next.back().factors.end(), right.factors.begin(), right.factors.end());
      }
    result = std::move(next);
  }
  return result;
}

ex product(const std::vector<ex>& factors) {
  if (factors.empty()) return 1;
  if (factors.size() == 1) return factors[0];
  return GiNaC::ncmul(factors);
}

ex sum(const std::vector<Term>& terms) {
  ex result = 0;
  for (const Term& term : terms) result += term.scalar * product(term.factors);
  return result;
}

Shape shape_of(const ex& e) {
  if (GiNaC::is_a<Atom>(e)) return GiNaC::ex_to<Atom>(e).shape();
  if (e.return_type() == GiNaC::return_types::commutative) return Shape::scalar;
  if (GiNaC::is_a<GiNaC::ncmul>(e)) return shape_of(e.op(e.nops() - 1));  // of A b and of A B
  if (is_ex_the_function(e, gyroscopic) || is_ex_the_function(e, inertia_moment)) return Shape::vector;
  const bool is_like_second =
      is_ex_the_function(e, forward) || is_ex_the_function(e, scaled) || is_ex_the_function(e, backward);
  if (is_like_second) return shape_of(e.op(1));
  if (GiNaC::is_a<GiNaC::function>(e)) return Shape::matrix;
  for (const ex& operand : e)  // of a sum, of a scalar times a block
    if (shape_of(operand) != Shape::scalar) return shape_of(operand);
  return Shape::scalar;
}

namespace {

ex transposed_factor(const ex& factor, const std::function<ex(const Atom&)>& of_atom) {
  if (GiNaC::is_a<Atom>(factor)) return of_atom(GiNaC::ex_to<Atom>(factor));
  if (is_ex_the_function(factor, skew)) return -factor;
  const bool is_symmetric = is_ex_the_function(factor, inverse) || is_ex_the_function(factor, congruence) ||
                            is_ex_the_function(factor, second_moment);
  if (is_symmetric) return factor;
  throw InternalError("transpose of a block that has none");
}

}  // namespace

ex transposed(const ex& e, const std::function<ex(const Atom&)>& of_atom) {
  ex result = 0;
  for (const Term& term : expanded(e)) {
    ex reversed = term.scalar;
    for (auto factor = term.factors.rbegin(); factor != term.factors.rend(); ++factor)
      reversed = reversed * transposed_factor(*factor, of_atom);
    result += reversed;
  }
  return sum(expanded(result));
}

ex time_derivative(const ex& e, const std::function<ex(const Atom&)>& rate) {
  if (GiNaC::is_a<Atom>(e)) return rate(GiNaC::ex_to<Atom>(e));
  if (is_ex_the_function(e, skew)) return skew(time_derivative(e.op(0), rate));
  if (GiNaC::is_a<GiNaC::numeric>(e)) return 0;
  const bool is_sum = GiNaC::is_a<GiNaC::add>(e);
  if (!is_sum && !GiNaC::is_a<GiNaC::mul>(e) && !GiNaC::is_a<GiNaC::ncmul>(e))
    throw InternalError("time derivative of a function that has none");
  ex result = 0;
  for (std::size_t i = 0; i < e.nops(); ++i) {
    ex part = 1;
    if (is_sum)
      part = time_derivative(e.op(i), rate);
    else
      for (std::size_t j = 0; j < e.nops(); ++j) part = part * (i == j ? time_derivative(e.op(j), rate) : e.op(j));
    result += part;
  }
  return sum(expanded(result));
}

namespace {

ex partial_by_scalar(const ex& e, const ex& y) {
  ex result = 0;
  for (const Term& term : expanded(e)) {
    const ex scalar = term.scalar.expand();
    if (!scalar.has(y)) continue;
    if (scalar.degree(y) != 1 || scalar.ldegree(y) != 1)
      throw InternalError("partial derivative of an expression that is not linear");
    result += scalar.coeff(y, 1) * product(term.factors);
  }
  return result;
}

}  // namespace

ex partial(const ex& e, const ex& y) {
  if (shape_of(y) == Shape::scalar) return partial_by_scalar(e, y);
  const ex cross = skew(y);
  ex result = 0;
  for (const Term& term : expanded(e)) {
    std::size_t at = term.factors.size();
    for (std::size_t i = 0; i < term.factors.size(); ++i) {
      if (!term.factors[i].has(y)) continue;
      if (at != term.factors.size()) throw InternalError("partial derivative of an expression that is not linear");
      at = i;
    }
    if (at == term.factors.size()) continue;
    const std::vector<ex> before(term.factors.begin(), term.factors.begin() + static_cast<std::ptrdiff_t>(at));
    const std::vector<ex> after(term.factors.begin() + static_cast<std::ptrdiff_t>(at) + 1, term.factors.end());
    if (term.factors[at].is_equal(y) && after.empty())
      result += term.scalar * product(before);
    else if (term.factors[at].is_equal(cross) && !after.empty())
      result -= term.scalar * (product(before) * skew(product(after)));
    else
      throw InternalError("partial derivative of an expression that is not linear");
  }
  return sum(expanded(result));
}

}  // namespace kanec::symbolic
