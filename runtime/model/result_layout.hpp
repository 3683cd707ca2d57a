// Names, shapes and units of what the functions return. Not: the functions themselves (functions.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/layout.hpp"

namespace kanec {

// One a part of the request, which the scene has; in the order of the results.
std::vector<Layout> result_layouts(const scene::Scene& scene, const std::string& request);

}  // namespace kanec
