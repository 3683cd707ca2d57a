// Where each coordinate and speed stands in x and y, and what it is called. Not: its value.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::scene {

struct Scene;

// Indices of one body's entries; -1 where that coordinate is locked or prescribed (or where there is none).
struct BodyLayout {
  int eps = -1;                     // first of 4 in x, of a ball that is not held
  int omega = -1;                   // first of 3 in y
  std::vector<int> theta, s;        // into x, one a turn, one a slide
  std::vector<int> thetadot, sdot;  // into y
};

// x = (all rotation coordinates ; all translations), y = (all rotation speeds ; all rates of translation), bodies in
// order.
struct Layout {
  explicit Layout(const Scene& scene);
  int nx = 0, ny = 0;
  std::vector<BodyLayout> bodies;  // of body K: [K - 1]
};

// One name an entry, in state order: letter, body, component where there are several ("eps_1_4", "theta_3", "s_2_1";
// "omega_1_2", "thetadot_3", "sdot_2_1"). Locked and prescribed components count: of a free joint whose first
// translation is locked, the others are s_2_2 and s_2_3.
std::vector<std::string> coordinate_names(const Scene& scene);
std::vector<std::string> speed_names(const Scene& scene);
std::vector<std::string> speed_rate_names(const Scene& scene);  // "omegadot_1_2", "thetaddot_3", "sddot_2_1"

}  // namespace kanec::scene
