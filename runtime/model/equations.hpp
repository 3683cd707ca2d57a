// The equations of a scene, on paper. Not: their derivation (generator/symbolic), nor their tables (generator/emit).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/scene/scene.hpp"

namespace kanec {

// format: "text", "latex" (a document that compiles), "json". Throws InputError for another one.
std::string equations_text(const scene::Scene& scene, const std::string& format);

}  // namespace kanec
