// What a run watches for, and what happens there. Not: how it is found (events.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::integrate {

// A zero of an entry of the model's function `events`.
struct Event {
  enum class Direction { both, up, down };
  struct Setting {
    int input;
    double value;
  };
  std::string name;
  Direction direction = Direction::both;
  bool stops = false;             // the run ends there
  bool has_row = false;           // the observer is given a row there
  std::vector<Setting> settings;  // inputs that change there
};

}  // namespace kanec::integrate
