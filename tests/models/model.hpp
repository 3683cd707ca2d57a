// A scene with its program, evaluated and counted by the names of functions. Not: emitted code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/ledger.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {

// Names of the folders under models/, sorted.
std::vector<std::string> shipped_models();

scene::Scene shipped_scene(const std::string& name);

class Model {
 public:
  // `functions`: those to derive; empty: the usual ones.
  explicit Model(const scene::Scene& scene, const std::vector<std::string>& functions = {});

  const scene::Scene& scene() const { return scene_; }
  const program::Program& program() const { return program_; }

  // The scene's own initial state, parameters and inputs at t = 0; ydot is zero.
  program::Arguments<double> start() const;

  std::vector<double> operator()(const std::string& function, const program::Arguments<double>& at) const;
  int operations(const std::string& function) const;

 private:
  const program::Function& function(const std::string& name) const;

  scene::Scene scene_;
  program::Program program_;
};

}  // namespace kanec::test
