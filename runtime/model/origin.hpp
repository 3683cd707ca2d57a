// What emitted code follows from, as a text that is known before anything is derived. Not: where it is kept
// (runtime/compile).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/pipeline.hpp"
#include "generator/scene/scene.hpp"

namespace kanec {

// The scene without what only runs read, to the last bit; the options; and the very build of the generator, by the
// build id that the linker gave it. Empty where there is none: then nothing short of the emitted text tells what a
// model is.
std::string origin_of(const scene::Scene& scene, const GenerateOptions& options);

}  // namespace kanec
