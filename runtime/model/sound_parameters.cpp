// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/sound_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "generator/read/eigenvalues.hpp"

namespace kanec {
namespace {

using scene::Number;

// Far from the limits of generator/read/check.cpp and node.cpp.
constexpr double least_mass = 1e-60, least_ratio_of_moments = 1e-6, largest = 1e50;

bool is_sound(const scene::Body& body, std::span<const double> parameters) {
  const scene::Symmetric& I = body.inertia;
  const Number* const numbers[] = {&body.mass, &I.xx, &I.yy, &I.zz, &I.xy, &I.xz, &I.yz};
  const auto is_parameter = [](const Number* number) { return number->kind == Number::Kind::parameter; };
  if (std::none_of(std::begin(numbers), std::end(numbers), is_parameter)) return true;
  double v[7];
  std::transform(std::begin(numbers), std::end(numbers), v, [&](const Number* number) {
    return is_parameter(number) ? parameters[static_cast<std::size_t>(number->index)] : number->value;
  });
  const auto moments = scene::eigenvalues({{{v[1], v[4], v[5]}, {v[4], v[2], v[6]}, {v[5], v[6], v[3]}}});
  return v[0] > least_mass && moments[2] > least_mass && moments[0] > least_ratio_of_moments * moments[2];
}

}  // namespace

bool surely_sound(const scene::Scene& scene, std::span<const double> parameters) {
  const auto is_moderate = [](double value) { return std::fabs(value) < largest; };
  return std::all_of(parameters.begin(), parameters.end(), is_moderate) &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const scene::Body& body) { return is_sound(body, parameters); });
}

}  // namespace kanec
