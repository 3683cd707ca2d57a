// What a simulation watches for: zeros of an expression, and what happens there. Not: how they are found
// (runtime/integrate/events).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/scene/number.hpp"

namespace kanec::scene {

struct Event {
  enum class Direction { both, up, down };  // up: the expression grows through zero
  enum class Action {
    record,  // told of
    stop,    // the run ends there
    set      // inputs get other values, for the rest of the run
  };
  struct Setting {
    int input = 0;  // into Scene::inputs
    double value = 0.0;
  };
  std::string name;
  Number expression;  // of the state or the time
  Direction direction = Direction::both;
  Action action = Action::record;
  std::vector<Setting> settings;  // of set
  bool row = false;               // the trajectory has a row there
};

}  // namespace kanec::scene
