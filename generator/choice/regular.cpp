// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/regular.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "generator/choice/requests.hpp"
#include "generator/program/evaluate.hpp"
#include "generator/scene/entry_names.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec {
namespace {

// A pivot below this part of its diagonal entry is what rounding leaves of zero.
constexpr double vanishing = 1e-13;

std::vector<double> mass_matrix(const scene::Scene& scene) {
  const program::Program program = program_of(scene, {"mass_matrix"});
  program::Arguments<double> at;
  at.parameters = default_parameters(scene);
  at.x = initial_coordinates(scene);
  at.y = initial_speeds(scene);
  at.inputs = default_inputs(scene);
  return program::evaluate(program, program.functions.front(), at);
}

// The first row, from the leaves, whose pivot vanishes when A is factored as L D Lᵀ; -1 where there is none.
int singular_row(std::vector<double> A, int n) {
  const auto at = [&](int i, int j) -> double& { return A[static_cast<std::size_t>(i * n + j)]; };
  std::vector<double> diagonal;
  for (int i = 0; i < n; ++i) diagonal.push_back(at(i, i));
  for (int pivot = n - 1; pivot >= 0; --pivot) {
    const double d = at(pivot, pivot);
    if (!(d > vanishing * diagonal[static_cast<std::size_t>(pivot)])) return pivot;
    for (int i = 0; i < pivot; ++i)
      for (int j = 0; j < pivot; ++j) at(i, j) -= at(i, pivot) * at(pivot, j) / d;
  }
  return -1;
}

bool has_free_joints_only(const scene::Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const scene::Body& body) { return body.joint.ball && body.joint.slides.size() == 3; });
}

// Number of the body that a speed belongs to, from 1.
int body_of(const scene::Scene& scene, int row) {
  const scene::Layout layout(scene);
  const auto has = [row](const std::vector<int>& list) {
    return std::find(list.begin(), list.end(), row) != list.end();
  };
  for (std::size_t k = 0; k < layout.bodies.size(); ++k) {
    const scene::BodyLayout& body = layout.bodies[k];
    const bool of_ball = body.omega >= 0 && row >= body.omega && row < body.omega + 3;
    if (of_ball || has(body.thetadot) || has(body.sdot)) return static_cast<int>(k) + 1;
  }
  throw InternalError("a speed of no body");
}

}  // namespace

void check_regular(const scene::Scene& scene) {
  constexpr int most = 200;  // speeds; beyond, the check would cost more than the rest of the work
  const int n = n_speeds(scene);
  if (n == 0 || n > most || has_free_joints_only(scene)) return;
  const int row = singular_row(mass_matrix(scene), n);
  if (row < 0) return;
  const int k = body_of(scene, row);
  throw InputError(
      "scene " + scene.name + ": body " + std::to_string(k) + " (" +
      scene.bodies[static_cast<std::size_t>(k - 1)].name + "): the acceleration of " +
      in_words(scene, speed_names(scene))[static_cast<std::size_t>(row)] +
      " is undetermined in the initial state (A is singular): no mass resists it, or other coordinates make the same "
      "motion; allowed: mass or inertia that it moves, axes that are not aligned, or the coordinate locked");
}

}  // namespace kanec
