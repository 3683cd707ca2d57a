// Scenes whose equations are printed in tests: all that are shipped, and random ones with names of every form. Not: any
// expectation.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::test {

// Scene files below models/, sorted.
std::vector<std::filesystem::path> shipped_scenes();

// Of everything that scenes can hold. Its names have underscores at the end and doubled, digits, suffixes as of
// components, or characters that TeX obeys.
scene::Scene scene_with_rough_names(int seed);

}  // namespace kanec::test
