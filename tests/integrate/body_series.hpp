// The Taylor series of the single body of tree_model.hpp, written by hand, for methods that step by series. Not: its
// rates.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {

inline constexpr double body_m = 2.0;                               // [kg]
inline constexpr std::array<double, 3> body_inertia = {3, 3, 1.5};  // principal moments, about the origin [kg m²]

// In double, of the state and the work of the loads, with the same fault.
const kanec_taylor& single_body_series(Fault fault);

}  // namespace kanec::integrate::test
