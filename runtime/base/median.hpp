// The median of measured figures. Not: any other statistics.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace kanec {

// Of one at least; of an even number the upper of the two in the middle.
double median(std::vector<double> values);

}  // namespace kanec
