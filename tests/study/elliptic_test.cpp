// Oracles: identities of Jacobi's functions, std::comp_ellint_1 where the modulus is not near 1, integrals in closed
// form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/elliptic.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kanec::hard::test {
namespace {

constexpr Real tolerance = 1e-17L;  // a hundred roundings of long double

TEST(Elliptic, functions_differentiate_into_each_other) {
  for (const Real complement : {1.0L, 0.7L, 0.01L, 1e-6L, 1e-12L}) {
    const Elliptic elliptic(complement);
    for (Real u = -3.0L; u < 3.0L; u += 0.37L) {
      const auto sn = [&](Real at) { return elliptic(at).sn; };
      const Jacobi f = elliptic(u);
      EXPECT_NEAR(static_cast<double>(f.sn * f.sn + f.cn * f.cn - 1), 0.0, 1e-18);
      EXPECT_NEAR(static_cast<double>(f.dn * f.dn + (1 - complement) * f.sn * f.sn - 1), 0.0, 1e-18);
      // d sn = cn dn du, by the integral over a tenth
      const Real change = integral([&](Real at) { return elliptic(at).cn * elliptic(at).dn; }, u, u + 0.1L, 0.1L);
      EXPECT_NEAR(static_cast<double>(sn(u + 0.1L) - f.sn - change), 0.0, 1e-17);
    }
  }
}

TEST(Elliptic, quarter_period_is_the_complete_integral) {
  for (const Real k : {0.0L, 0.3L, 0.9L})
    EXPECT_NEAR(static_cast<double>(Elliptic(1 - k * k).quarter_period() - std::comp_ellint_1(k)), 0.0, 1e-17);
  // K = ln(4/k') + (ln(4/k') − 1) k'²/4 + …
  const Real log = std::log(4 / 1e-6L);
  EXPECT_NEAR(static_cast<double>(Elliptic(1e-12L).quarter_period() - log), 0.0, 1e-11);
}

TEST(Elliptic, argument_undoes_sn_and_cn) {
  for (const Real complement : {0.9L, 0.05L, 1e-8L}) {
    const Elliptic elliptic(complement);
    for (Real share = -1.9L; share < 2.0L; share += 0.3L) {
      const Real u = share * elliptic.quarter_period();
      const Jacobi f = elliptic(u);
      // near the middle of a period sn is flat on a scale of k': the argument has that much fewer digits
      EXPECT_NEAR(static_cast<double>(elliptic.argument(f.sn, f.cn) - u), 0.0,
                  1e-17 / std::sqrt(static_cast<double>(complement)));
    }
  }
}

TEST(Elliptic, period_is_four_quarters_however_often) {
  const Elliptic elliptic(0.0136L);
  const Real u = 0.4L, many = 4 * 500 * elliptic.quarter_period();
  EXPECT_NEAR(static_cast<double>(elliptic(u + many).sn - elliptic(u).sn), 0.0, 1e-15);
}

TEST(Integral, of_a_smooth_function_has_all_digits) {
  EXPECT_NEAR(static_cast<double>(integral([](Real x) { return std::exp(x); }, -1, 2, 0.5L) -
                                  (std::exp(2.0L) - std::exp(-1.0L))),
              0.0, static_cast<double>(10 * tolerance));
}

}  // namespace
}  // namespace kanec::hard::test
