// Euler parameters brought to unit norm. Not: what is said of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "generator/scene/layout.hpp"

namespace kanec {

struct UnitNorm {
  struct Off {
    int body;  // from 1
    double norm;
  };
  int zero = 0;          // the first body whose Euler parameters are all zero; 0: none
  std::vector<Off> off;  // those that were off by more than 1e-6, which is worth a note
};

// Norms within 1e-15 of 1 differ from it by rounding alone, and are left as they stand.
UnitNorm to_unit_norm(const scene::Layout& layout, std::span<double> x);

}  // namespace kanec
