// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/symbolic/alphabet.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace kanec::symbolic {

using GiNaC::ex;

Alphabet::Alphabet() {
  const auto add = [this](const char* name, Shape shape) { return table.add(Role::quantity, name, name, "", shape); };
  a = add("a", Shape::vector), b = add("b", Shape::vector), c = add("c", Shape::vector);
  A = add("A", Shape::matrix), R = add("R", Shape::matrix), Rt = add("Rt", Shape::matrix);
  Q = add("Q", Shape::matrix), Qt = add("Qt", Shape::matrix);
  m = add("m", Shape::scalar), n = add("n", Shape::scalar);
  table.pair(R, Rt);
  table.pair(Q, Qt);
}

ex Alphabet::vector(test::Random& random) const {
  return std::array{a, b, c}[static_cast<std::size_t>(random.below(3))];
}

ex Alphabet::factor(test::Random& random) const {
  const std::array matrices = {A, R, Rt, Q, Qt};
  if (random.chance(0.5)) return matrices[static_cast<std::size_t>(random.below(5))];
  return random.chance(0.7) ? skew(vector(random)) : skew(vector(random) + 2 * vector(random));
}

ex Alphabet::term(test::Random& random, bool ends_in_vector) const {
  ex result = GiNaC::numeric(random.below(7) - 3, 1 + random.below(2));
  if (random.chance(0.5)) result *= random.chance(0.5) ? m : n;
  for (int i = random.below(4) + (ends_in_vector ? 0 : 1); i > 0; --i) result = result * factor(random);
  return ends_in_vector ? result * vector(random) : result;
}

ex Alphabet::sum(test::Random& random, int n_terms, bool ends_in_vector) const {
  ex result = 0;
  for (int i = 0; i < n_terms; ++i) result += term(random, ends_in_vector);
  return result;
}

namespace {

Value random_value(int rows, int columns, test::Random& random) {
  Value value(rows, columns);
  for (Eigen::Index i = 0; i < value.size(); ++i) value(i) = Real(random.uniform(-1, 1), random.uniform(-1, 1));
  return value;
}

Value scalar(const Real& value) { return Value::Constant(1, 1, value); }

Real power(const Real& base, int exponent) {
  Real result(1);
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? Real(1) / result : result;
}

Value skew_value(const Value& a) {
  Value result(3, 3);
  result << Real(0), -a(2), a(1), a(2), Real(0), -a(0), -a(1), a(0), Real(0);
  return result;
}

Value product(const Value& a, const Value& b) {
  if (a.size() == 1) return b * a(0);
  if (b.size() == 1) return a * b(0);
  return a * b;
}

}  // namespace

Values::Values(const SymbolTable& table, test::Random& random) {
  for (const Symbol& symbol : table.all()) {
    const Atom& atom = GiNaC::ex_to<Atom>(symbol.atom);
    const int index = atom.index();
    if (values_.count(index) > 0) continue;
    const int rows = atom.shape() == Shape::scalar ? 1 : 3;
    const Value value = random_value(rows, atom.shape() == Shape::matrix ? 3 : 1, random);
    const bool symmetric = atom.shape() == Shape::matrix && symbol.transpose.is_equal(symbol.atom);
    values_[index] = symmetric ? Value(value + value.transpose()) : value;
    if (atom.shape() == Shape::matrix && !symmetric)
      values_[GiNaC::ex_to<Atom>(symbol.transpose).index()] = value.transpose();
  }
}

void Values::set(const ex& letter, const Value& value) { values_[GiNaC::ex_to<Atom>(letter).index()] = value; }

Value Values::of(const ex& e) const {
  if (GiNaC::is_a<Atom>(e)) return values_.at(GiNaC::ex_to<Atom>(e).index());
  if (GiNaC::is_a<GiNaC::numeric>(e)) return scalar(GiNaC::ex_to<GiNaC::numeric>(e).to_double());
  if (GiNaC::is_a<GiNaC::power>(e))
    return scalar(power(of(e.op(0))(0), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int()));
  if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
  Value result = of(e.op(0));
  for (std::size_t i = 1; i < e.nops(); ++i) {
    const Value next = of(e.op(i));
    result = GiNaC::is_a<GiNaC::add>(e) ? Value(result + next) : product(result, next);
  }
  return result;
}

Value Values::function(const ex& e) const {
  if (is_ex_the_function(e, skew)) return skew_value(of(e.op(0)));
  if (is_ex_the_function(e, dot)) return of(e.op(0)).transpose() * of(e.op(1));
  if (is_ex_the_function(e, rotation)) {
    const Value cross = skew_value(of(e.op(0)));
    return Value::Identity(3, 3) + cross * (Real(2) * of(e.op(1))(0)) + cross * cross * Real(2);
  }
  throw std::invalid_argument("no value of this function");
}

Eigen::MatrixXd Values::rate(const ex& e) const { return test::rates(of(e)); }

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return HUGE_VAL;
  return (a - b).cwiseAbs().maxCoeff() / std::max({1.0, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
}

double difference(const Value& a, const Value& b) {
  const auto plain = [](const Value& v) { return v.unaryExpr([](const Real& r) { return r.value; }).eval(); };
  return difference(Eigen::MatrixXd(plain(a)), Eigen::MatrixXd(plain(b)));
}

}  // namespace kanec::symbolic
