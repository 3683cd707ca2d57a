// A scene of models/.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/read/read.hpp"

namespace kanec::test {

inline scene::Scene shipped(const std::string& model) {
  return scene::read(KANEC_SOURCE_DIR "/models/" + model + "/scene.toml");
}

}  // namespace kanec::test
