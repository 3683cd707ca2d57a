// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/scene_files.hpp"

#include <algorithm>
#include <filesystem>

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_scene(const fs::path& path) {
  std::error_code ignored;
  return !is_folder(path) || fs::exists(path / "scene.toml", ignored);
}

}  // namespace

std::string typed(const std::string& path) { return fit::shell(path.starts_with('-') ? "./" + path : path); }

std::string scene_file(const std::string& path) {
  return is_folder(path) ? (fs::path(path) / "scene.toml").string() : path;
}

std::vector<std::string> scene_files(const std::string& word) {
  if (is_scene(word)) return {scene_file(word)};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(word))
    if (is_folder(entry.path()) && is_scene(entry.path())) files.push_back(scene_file(entry.path().string()));
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw InputError("SCENE: found '" + word +
                     "', in which no folder holds a scene.toml; allowed: scenes, or a folder of them");
  return files;
}

}  // namespace kanec
