// The scene files that a word of a user means. Not: how scenes are read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace kanec {

// A path as it is typed into a shell where a scene may stand: no option, one word.
std::string typed(const std::string& path);

// A scene.toml, or that of a folder.
std::string scene_file(const std::string& path);

// A scene.toml, or that of a folder, or those of a folder of such folders, by name. Throws InputError for a folder that
// holds neither.
std::vector<std::string> scene_files(const std::string& word);

}  // namespace kanec
