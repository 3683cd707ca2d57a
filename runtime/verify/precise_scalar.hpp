// What Eigen asks of a scalar beyond Precise's own operators, so that the generic path is evaluated in 50 digits. Not:
// the arithmetic (precise.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>

#include "runtime/verify/precise.hpp"

namespace kanec {

inline Precise& operator+=(Precise& a, const Precise& b) { return a = a + b; }
inline Precise& operator-=(Precise& a, const Precise& b) { return a = a - b; }
inline Precise& operator*=(Precise& a, const Precise& b) { return a = a * b; }
inline Precise& operator/=(Precise& a, const Precise& b) { return a = a / b; }

inline bool operator>(const Precise& a, const Precise& b) { return b < a; }
inline bool operator<=(const Precise& a, const Precise& b) { return !(b < a); }
inline bool operator>=(const Precise& a, const Precise& b) { return !(a < b); }
inline bool operator==(const Precise& a, const Precise& b) { return !(a < b) && !(b < a); }
inline bool operator!=(const Precise& a, const Precise& b) { return !(a == b); }

}  // namespace kanec

namespace Eigen {

template <>
struct NumTraits<kanec::Precise> : GenericNumTraits<kanec::Precise> {
  using Real = kanec::Precise;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 50,
    MulCost = 100
  };
  static Real epsilon() { return Real(1e-50); }
  static Real dummy_precision() { return Real(1e-45); }
  static int digits10() { return 50; }
};

}  // namespace Eigen
