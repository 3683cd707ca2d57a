// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "generator/read/connection.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/hash.hpp"

namespace kanec::scene {
namespace {

constexpr std::size_t longest_spelled = 16;  // bodies whose numbers are written out in the name

Number add(std::vector<Named>& list, Number (*kind)(int), const std::string& name, double value) {
  list.push_back({name, value});
  return kind(static_cast<int>(list.size()) - 1);
}

Vector add_vector(std::vector<Named>& list, Number (*kind)(int), const std::string& letter,
                  const std::array<double, 3>& values) {
  Vector out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = add(list, kind, letter + "_" + std::to_string(i + 1), values[i]);
  return out;
}

// Principal moments near 0.08, 0.10, 0.12: positive definite, and within the triangle inequality.
Symmetric add_inertia(std::vector<Named>& list, const std::string& letter) {
  const auto entry = [&](const char* axes, double value) {
    return add(list, Number::parameter, letter + "_" + axes, value);
  };
  Symmetric inertia;
  inertia.xx = entry("xx", 0.10);
  inertia.yy = entry("yy", 0.12);
  inertia.zz = entry("zz", 0.08);
  inertia.xy = entry("xy", 0.005);
  inertia.xz = entry("xz", 0.003);
  inertia.yz = entry("yz", -0.004);
  return inertia;
}

Body symbolic_body(Scene& scene, int k, int lower) {
  const auto numbered = [k](std::string letter) { return letter.append("_").append(std::to_string(k)); };
  Body body;
  body.name = numbered("body");
  body.mass = add(scene.parameters, Number::parameter, numbered("m"), 1.0);
  body.inertia = add_inertia(scene.parameters, numbered("I"));
  body.r = add_vector(scene.parameters, Number::parameter, numbered("r"), {0.1, 0.2, 0.05});
  // on the inertial frame q only shifts the origin of s: the source's q_1 = 0
  if (lower > 0) body.q = add_vector(scene.parameters, Number::parameter, numbered("q"), {0.3, 0.0, 0.1});
  body.force = add_vector(scene.inputs, Number::input, numbered("F"), {0, 0, 0});
  body.moment = add_vector(scene.inputs, Number::input, numbered("M"), {0, 0, 0});
  body.initial.omega = {0.1, -0.2, 0.3};
  body.joint.slides[0].rate = 0.01;
  body.joint.slides[1].rate = 0.02;
  body.joint.slides[2].rate = -0.01;
  return body;
}

std::string joined_numbers(const std::vector<int>& lower, const char* separator) {
  std::string text;
  for (const int l : lower) text += (text.empty() ? "" : separator) + std::to_string(l);
  return text;
}

std::string tree_name(const std::vector<int>& lower) {
  if (lower.size() > longest_spelled)
    return "tree_" + std::to_string(lower.size()) + "_" + fingerprint(joined_numbers(lower, ","));
  // run together, "11" would be both 1, 1 and 11
  const bool long_numbers = std::any_of(lower.begin(), lower.end(), [](int l) { return l > 9; });
  return "tree_" + joined_numbers(lower, long_numbers ? "_" : "");
}

}  // namespace

Scene from_connection(const std::vector<int>& lower) {
  check_connection(lower, [](std::size_t k) {
    return Place{.file = "connection array", .field = k == 0 ? "" : "number " + std::to_string(k)};
  });
  Scene scene;
  scene.name = tree_name(lower);
  scene.lower = lower;
  for (std::size_t k = 0; k < lower.size(); ++k)
    scene.bodies.push_back(symbolic_body(scene, static_cast<int>(k) + 1, lower[k]));
  scene.gravity = add_vector(scene.parameters, Number::parameter, "g", {0, 0, -9.81});
  return scene;
}

}  // namespace kanec::scene
