// The work-precision diagram of a scene's runs. Not: how points and lines are drawn (diagram.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "runtime/study/report/integration.hpp"

namespace kanec {

// Wall time over worst error, a line a method, as SVG.
std::string integration_svg(const SceneRuns& scene);

}  // namespace kanec
