// A scene written as the TOML file that reads back as the same scene (Euler parameters and frames on a body may be
// rounded again, as reading normalises them). Not: comments, which nobody kept.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/scene/scene.hpp"

namespace kanec {

std::string scene_text(const scene::Scene& scene);

}  // namespace kanec
