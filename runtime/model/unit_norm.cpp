// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/unit_norm.hpp"

#include <cmath>

namespace kanec {

UnitNorm to_unit_norm(const scene::Layout& layout, std::span<double> x) {
  constexpr double rounding = 1e-15, worth_a_note = 1e-6;
  UnitNorm result;
  for (int k = 1; k <= static_cast<int>(layout.bodies.size()); ++k) {
    const int at = layout.bodies[static_cast<std::size_t>(k - 1)].eps;
    if (at < 0) continue;
    double* eps = &x[static_cast<std::size_t>(at)];
    const double norm = std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3]));
    if (norm == 0.0 && result.zero == 0) result.zero = k;
    if (norm == 0.0 || std::fabs(norm - 1.0) <= rounding) continue;
    for (int i = 0; i < 4; ++i) eps[i] /= norm;
    if (std::fabs(norm - 1.0) > worth_a_note) result.off.push_back({k, norm});
  }
  return result;
}

}  // namespace kanec
