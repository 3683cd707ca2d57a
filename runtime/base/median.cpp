// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/median.hpp"

#include <algorithm>

namespace kanec {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace kanec
