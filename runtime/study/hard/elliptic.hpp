// Jacobi's elliptic functions and integrals of smooth functions in long double: what closed forms of rigid bodies are
// made of. Not: double's std::comp_ellint_1 and its relatives, which lose the complementary modulus near 1.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

namespace kanec::hard {

using Real = long double;

struct Jacobi {
  Real sn, cn, dn;
};

// The modulus by its complement k'² = 1 − k², which is what is small near a separatrix; 0 < k'² ≤ 1.
class Elliptic {
 public:
  explicit Elliptic(Real complement);

  Real quarter_period() const { return quarter_; }  // K
  Jacobi operator()(Real u) const;
  // u in [−2K, 2K] with this sn and cn, which need not be of unit norm to the last digit.
  Real argument(Real sn, Real cn) const;

 private:
  static constexpr int most = 16;
  Real complement_, quarter_;
  int n_ = 0;
  Real a_[most], c_[most];
};

// Carlson's R_F.
Real carlson(Real x, Real y, Real z);

// ∫ f from a to b by Gauss and Legendre's rule of sixteen points on equal panels of at most `longest`.
Real integral(const std::function<Real(Real)>& f, Real a, Real b, Real longest);

}  // namespace kanec::hard
