// Random states of a scene, the same for the same seed everywhere. Not: parameters beside their defaults
// (runtime/verify/samples.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec {

// Not the standard library's distributions, which differ from one library to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::vector<double> numbers(std::size_t count);  // each between -1 and 1
  void unit(double* eps);                          // four, uniform on the sphere

 private:
  std::mt19937_64 engine_;
};

struct RandomState {
  double t = 0.0;  // [s]
  std::vector<double> x, y, ydot;
};

// Whether anything in the scene is an expression of time.
bool reads_time(const scene::Scene& scene);

// Euler parameters of unit norm, any angles (where three axes turn one after another, the second angle keeps them from
// lying in one plane), all other coordinates, speeds and rates between -1 and 1 of their unit, and the time, where the
// scene depends on it, between 0 and 1 s.
RandomState random_state(const scene::Scene& scene, Random& random);

// Within 1 + |default| of the scene's own.
std::vector<double> random_inputs(const scene::Scene& scene, Random& random);

}  // namespace kanec
