// Published states of trees with free, ball and revolute joints in relative joint coordinates, converted to absolute ε
// and ω, s in the lower body's axes, and the scene's loads. Not: any of the equations of motion.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::test {

// tests/data/reference_*.json say what each is.
struct ReferenceState {
  std::vector<double> q, v, tau, vdot;  // of a free body 7, 6, 6, 6; of a ball 4, 3, 3, 3; of a revolute one each
  std::vector<double> bias, momentum;   // as many as v
  std::vector<double> origins;          // 3 a body
  double kinetic = 0, potential = 0;
};

struct Reference {
  // Its inputs, body by body: of a free one F and M entry by entry (6); of the others the torque of the joint (3 or 1).
  scene::Scene scene;
  std::vector<ReferenceState> states;
};

// Throws FileError, or an exception of the JSON library.
Reference read_reference(const std::filesystem::path& path);

// A reference state as the scene has it, with the published accelerations, and the joint forces as applied loads.
template <class Real>
struct Converted {
  Eigen::Matrix<Real, Eigen::Dynamic, 1> x, y, ydot, u;
};

// Real: double or long double. y is linear in the state's v, ydot affine in its vdot.
template <class Real>
Converted<Real> convert(const scene::Scene& scene, const ReferenceState& state);

extern template Converted<double> convert(const scene::Scene&, const ReferenceState&);
extern template Converted<long double> convert(const scene::Scene&, const ReferenceState&);

}  // namespace kanec::test
