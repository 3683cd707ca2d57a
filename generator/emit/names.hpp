// Names of the state's entries as constants in emitted code: x[at::theta_3]. Not: the layout itself (scene/layout.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/emit/language.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::emit {

// namespace at with the index of every entry of x and y, and where a body has a name of its own the same by that name:
// "theta_3" and "elbow_theta", "eps_1_4" and "hub_eps_4".
std::string state_constants(const scene::Scene& scene, const Syntax& syntax);

}  // namespace kanec::emit
