// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/ulps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kanec {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

double ulp_of(double value, int digits) { return std::ldexp(1.0, std::max(std::ilogb(value), -1022) - digits + 1); }

double in_ulps(double error, double size, int digits) {
  return error == 0.0 ? 0.0 : size == 0.0 ? infinite : error / ulp_of(size, digits);
}

double largest(const std::vector<Precise>& values) {
  double size = 0.0;
  for (const Precise& value : values) size = std::max(size, value.magnitude().rounded());
  return size;
}

double difference(const std::vector<double>& found, const std::vector<Precise>& exact) {
  double error = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!std::isfinite(found[i])) return infinite;
    error = std::max(error, (Precise(found[i]) - exact[i]).magnitude().rounded());
  }
  return error;
}

}  // namespace kanec
