// Random numbers that are the same on every machine and library. Not std's distributions, which are not.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace kanec::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // In [low, high), from the engine's upper 53 bits.
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  // 0 to n - 1.
  int below(int n) { return static_cast<int>(uniform(0, n)); }
  bool chance(double share) { return uniform(0, 1) < share; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace kanec::test
