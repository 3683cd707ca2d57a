// A scene with its program and one state: the same function evaluated through the program and on the generic numeric
// path, which shares no code with the generator. Not: emitted code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "generator/program/evaluate.hpp"
#include "runtime/generic/evaluate.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {

struct Sample {
  scene::Scene scene;
  State state;
  std::vector<double> parameters, inputs;
  double t = 0;
};

// Random state, parameters and inputs for the scene.
Sample sample_of(const scene::Scene& scene, Random& random);

// The whole generator up to the optimised program.
program::Program program_of(const scene::Scene& scene, const std::vector<std::string>& functions = {});

template <class T>
std::vector<T> as(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

// The sample's arguments in T, with |ε| = 1 to the rounding of T: the mass matrix is emitted with R R^T = 1.
template <class T>
program::Arguments<T> arguments(const Sample& s) {
  std::vector<T> x = as<T>(s.state.x);
  for (const scene::BodyLayout& at : scene::Layout(s.scene).bodies) {
    if (at.eps < 0) continue;
    T* eps = x.data() + at.eps;
    const T norm = std::sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
    for (int i = 0; i < 4; ++i) eps[i] /= norm;
  }
  return {as<T>(s.parameters), x, as<T>(s.state.y), as<T>(s.state.ydot), as<T>(s.inputs), T(s.t)};
}

template <class T>
program::Arguments<long double> widened(const program::Arguments<T>& a) {
  const auto wide = [](const std::vector<T>& v) { return std::vector<long double>(v.begin(), v.end()); };
  return {wide(a.parameters), wide(a.x), wide(a.y), wide(a.ydot), wide(a.inputs), static_cast<long double>(a.time)};
}

// The function's result by loops over the scene, in long double. Parameters are those of the sample.
std::vector<long double> generic_result(const Sample& s, const std::string& function,
                                        const program::Arguments<long double>& arguments);

// Largest difference of two results, relative to the largest entry of the second, or to `least` where all of it cancels
// to less than that.
template <class T>
double relative_difference(const std::vector<T>& found, const std::vector<long double>& expected,
                           long double least = 0) {
  if (found.size() != expected.size()) return HUGE_VAL;
  long double largest = 0;
  long double scale = least;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const long double difference = std::abs(static_cast<long double>(found[i]) - expected[i]);
    if (!(difference <= largest)) largest = difference;  // also where it is no number
    scale = std::max(scale, std::abs(expected[i]));
  }
  return static_cast<double>(scale == 0 ? largest : largest / scale);
}

// The connection array of a chain.
inline std::vector<int> chain(int n) {
  std::vector<int> lower;
  for (int k = 0; k < n; ++k) lower.push_back(k);
  return lower;
}

}  // namespace kanec::test
