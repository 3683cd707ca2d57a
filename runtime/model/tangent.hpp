// Derivatives by Euler parameters, as far as they mean anything: along the unit sphere. Not: any other derivative.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/result_layout.hpp"

namespace kanec {

// Columns of a matrix by x (rows × nx) in the directions of ξ (rows × ny): of a ball, those of the rotation vector φ in
// body axes, δe = ½(ε4 φ + e × φ), δε4 = -½ e·φ; of all other coordinates, themselves.
template <class Real>
std::vector<Real> along_tangent(const scene::Scene& scene, const std::vector<double>& x,
                                const std::vector<Real>& by_x) {
  const scene::Layout layout(scene);
  const auto nx = static_cast<std::size_t>(layout.nx), ny = static_cast<std::size_t>(layout.ny);
  std::vector<Real> result(nx == 0 ? 0 : by_x.size() / nx * ny, Real(0));
  const auto add = [&](int from, int to, Real factor) {
    for (std::size_t row = 0; row * nx < by_x.size(); ++row)
      result[row * ny + static_cast<std::size_t>(to)] += factor * by_x[row * nx + static_cast<std::size_t>(from)];
  };
  for (const scene::BodyLayout& at : layout.bodies) {
    for (std::size_t i = 0; i < at.theta.size(); ++i)
      if (at.theta[i] >= 0) add(at.theta[i], at.thetadot[i], 1);
    for (std::size_t i = 0; i < at.s.size(); ++i)
      if (at.s[i] >= 0) add(at.s[i], at.sdot[i], 1);
    if (at.eps < 0) continue;
    const double* e = &x[static_cast<std::size_t>(at.eps)];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;  // e × (unit vector i) has e_k in entry j, -e_j in entry k
      add(at.eps + i, at.omega + i, Real(e[3]) / 2);
      add(at.eps + j, at.omega + i, Real(e[k]) / 2);
      add(at.eps + k, at.omega + i, -Real(e[j]) / 2);
      add(at.eps + 3, at.omega + i, -Real(e[i]) / 2);
    }
  }
  return result;
}

// The results of these functions with derivatives by x replaced by those along the tangent: what formulas that differ
// off unit norm have in common.
template <class Real>
std::vector<Real> comparable(const scene::Scene& scene, const std::vector<std::string>& parts,
                             const std::vector<double>& x, const std::vector<Real>& values) {
  std::vector<Real> result;
  auto at = values.begin();
  for (const std::string& part : parts) {
    const auto end = at + static_cast<std::ptrdiff_t>(result_layouts(scene, part).front().size());
    const std::vector<Real> own(at, end);
    const bool by_x = part == "residual_x" || part == "accelerations_x" || part == "power_x";
    const std::vector<Real> kept = by_x ? along_tangent(scene, x, own) : own;
    result.insert(result.end(), kept.begin(), kept.end());
    at = end;
  }
  return result;
}

}  // namespace kanec
