// What the tests of written files share: a folder of their own, names of a state, a row. Not: any expectation.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "runtime/trajectory/trajectory.hpp"

namespace kanec::integrate::test {

inline StateNames free_names(int n_bodies) {
  StateNames names;
  const auto add = [n_bodies](std::vector<std::string>& list, const std::string& name, int width) {
    for (int k = 1; k <= n_bodies; ++k)
      for (int i = 1; i <= width; ++i) list.push_back(name + "_" + std::to_string(k) + "_" + std::to_string(i));
  };
  add(names.coordinates, "eps", 4);
  add(names.coordinates, "s", 3);
  add(names.speeds, "omega", 3);
  add(names.speeds, "sdot", 3);
  return names;
}

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "kanec-test.XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  bool is_empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

}  // namespace kanec::integrate::test
