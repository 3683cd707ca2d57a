// Letters, random expressions of them, and their values as numbers and matrices: the yardstick for block algebra. Not:
// the generator's own rules; a~ and R^T are evaluated as what they stand for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "generator/symbolic/symbols.hpp"
#include "tests/support/dual.hpp"
#include "tests/support/random.hpp"

namespace kanec::symbolic {

// A few letters of every shape.
struct Alphabet {
  Alphabet();
  SymbolTable table;
  GiNaC::ex a, b, c;          // vectors
  GiNaC::ex A, R, Rt, Q, Qt;  // matrices: A symmetric, Q and R with their transposes
  GiNaC::ex m, n;             // scalars

  GiNaC::ex vector(test::Random& random) const;  // a, b or c
  GiNaC::ex factor(test::Random& random) const;  // a matrix letter or a skew matrix
  // A scalar times up to three factors, and a vector behind them if wanted.
  GiNaC::ex term(test::Random& random, bool ends_in_vector) const;
  GiNaC::ex sum(test::Random& random, int n_terms, bool ends_in_vector) const;
};

// Values of letters by table index, and of expressions.
using Real = test::Dual<double>;
using Value = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

class Values {
 public:
  // Random values and rates for all letters of a table; a transpose gets the transposed ones.
  Values(const SymbolTable& table, test::Random& random);
  void set(const GiNaC::ex& letter, const Value& value);
  Value of(const GiNaC::ex& e) const;
  Eigen::MatrixXd rate(const GiNaC::ex& e) const;

 private:
  Value function(const GiNaC::ex& e) const;
  std::map<int, Value> values_;
};

// Largest difference of values, relative to the largest of them or to 1.
double difference(const Value& a, const Value& b);
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace kanec::symbolic
