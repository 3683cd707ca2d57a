// The diagram of time and rounding error of a scene's emitted functions. Not: how points are drawn (diagram.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "runtime/study/report/evaluation.hpp"

namespace kanec {

// Nanoseconds over ulps of double, a marker a variant of a function, as SVG. The scene has variants.
std::string evaluation_svg(const SceneErrors& scene);

}  // namespace kanec
