// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/ulp_errors.hpp"

#include <algorithm>

#include "runtime/base/median.hpp"
#include "runtime/verify/ulps.hpp"

namespace kanec {

UlpErrors StateErrors::summary(int digits) const {
  std::vector<double> sizes, ulps;
  for (std::size_t i = 0; i < n_random_; ++i)
    if (list_[i] && list_[i]->size > 0.0) sizes.push_back(list_[i]->size);
  const double usual = sizes.empty() ? 0.0 : median(sizes);
  UlpErrors result;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!list_[i]) continue;
    const double error = in_ulps(list_[i]->error, std::max(list_[i]->size, usual), digits);
    if (i < n_random_) ulps.push_back(error);
    double& worst = i < n_random_ ? result.largest : result.hard;
    worst = std::max(worst, error);
  }
  if (!ulps.empty()) result.median = median(ulps);
  return result;
}

}  // namespace kanec
