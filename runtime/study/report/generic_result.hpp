// What the generic path has in a state, as far as other ways can be compared with it. Not: the comparison.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/model/tangent.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/precise_scalar.hpp"

namespace kanec {

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_finite(const Precise&) { return true; }

// Nothing where it has no result.
template <class Real>
std::optional<std::vector<Real>> generic_result(const scene::Scene& scene, const std::vector<std::string>& parts,
                                                const State& state) {
  try {
    const std::vector<Real> values = generic_path<Real>(scene, parts, state);
    if (!std::all_of(values.begin(), values.end(), [](const Real& value) { return is_finite(value); })) return {};
    return comparable(scene, parts, state.x, values);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace kanec
