// How errors of results are measured: in units in the last place of the largest component. Not: which results are
// compared (agreement.hpp, report/evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "runtime/verify/precise.hpp"

namespace kanec {

// 2^(1 - digits) of the binade of the number, of double where nothing is said; of float 24.
double ulp_of(double value, int digits = 53);

// 0 / 0 counts as 0; infinite where only the size is 0.
double in_ulps(double error, double size, int digits = 53);

// The largest component.
double largest(const std::vector<Precise>& values);

// The largest error of a component; infinite where a number is not finite.
double difference(const std::vector<double>& found, const std::vector<Precise>& exact);

}  // namespace kanec
