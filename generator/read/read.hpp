// From a TOML text or a bare connection array to a checked Scene. Not: what is done with it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Reads and checks a scene; models/README.md documents every key. Throws SceneError, FileError.
Scene read(const std::filesystem::path& path);

// The same from text; `file` only names it in messages.
Scene parse(std::string_view text, const std::string& file);

// "0,1,2,2,1,5" to the array. Throws SceneError.
std::vector<int> parse_connection(std::string_view text);

// The all-symbolic system of a tree: every mass, inertia, r, q and gravity a parameter with a sound default, every
// applied force and moment an input. q is zero on the inertial frame. Named "tree_" and the array's numbers
// ("tree_012215"; with underscores between them where one has two digits; beyond 16 bodies "tree_<N>_<fingerprint>").
// Throws SceneError.
Scene from_connection(const std::vector<int>& lower);

}  // namespace kanec::scene
