// Dual numbers along a motion, for tests that differentiate in time. Not: the arithmetic (runtime/generic/dual.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "runtime/generic/dual.hpp"

namespace kanec::test {

using generic::Dual;

// Values along a motion: each entry with its rate.
template <class Real>
Eigen::Matrix<Dual<Real>, Eigen::Dynamic, 1> along(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& values,
                                                   const Eigen::Matrix<Real, Eigen::Dynamic, 1>& rates) {
  return values.binaryExpr(rates, [](const Real& value, const Real& rate) { return Dual<Real>(value, rate); });
}

// The rates of an expression in dual numbers.
template <class Derived>
auto rates(const Eigen::MatrixBase<Derived>& a) {
  return a.unaryExpr([](const auto& entry) { return entry.rate; }).eval();
}

}  // namespace kanec::test
