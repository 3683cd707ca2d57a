// A chain of masses between two walls, with stiff springs and dampers and all derivatives, and its modes in closed
// form. Not: its integration.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/abi/abi.h"
#include "tests/integrate/closed_form.hpp"

namespace kanec::integrate::test {

inline constexpr int chain_masses = 50;
// Stiffness of every spring [N/m], of a damper over that of its spring [s]; masses are 1 kg.
inline constexpr double chain_stiffness = 1e6, chain_retardation = 0.02;

// With derivatives or without.
enum class Derivatives { all, none };
const kanec_model& stiff_chain(Derivatives derivatives = Derivatives::all);

// The slowest and the fastest mode, released from rest: mode j is sin(π i j / (n + 1)) in mass i and obeys
// q̈ = -ω² (q + τ q̇), ω² = k (2 - 2 cos(π j / (n + 1))).
State chain_motion(double t);

}  // namespace kanec::integrate::test
