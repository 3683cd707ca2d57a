// The functions that a scene's solver can have, by name. Not: what they compute, nor the layout of their results.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"

namespace kanec {

// Which of y and ydot have to be given.
struct Needs {
  bool y = false;
  bool ydot = false;
};

// A request is a name, or several joined by '+', which become one function: "kinematics+accelerations".
std::vector<std::string> parts_of(const std::string& request);
std::string emitted_name(const std::string& request);  // "kinematics_and_accelerations"

// The parts of an emitted function, where these were the requests: itself where none of them combines it.
std::vector<std::string> parts_of_emitted(const std::string& name, const std::vector<std::string>& requests);

class Functions {
 public:
  explicit Functions(const scene::Scene& scene);  // derives the scene, once

  const std::vector<Available>& all() const { return all_; }
  std::vector<std::string> names() const;
  bool has(const std::string& name) const;  // not combined

  // Throws InputError, with the nearest known name, unless all parts of the request are known and different.
  void check(const std::string& request) const;
  // Checked; throws InputError for one that stands there twice.
  std::vector<std::string> chosen(const std::vector<std::string>& requests) const;
  // Of all parts together.
  Needs needs(const std::string& request) const;

 private:
  std::vector<Available> all_;
};

}  // namespace kanec
