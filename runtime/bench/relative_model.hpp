// A scene as other engines have it: every joint relative to the lower body, welded bodies as one, defaults of the
// parameters put in. Not: states (relative_state.hpp), nor any engine.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <stdexcept>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/bench/peer_abi.h"

namespace kanec {

// The message is the cause: "a locked coordinate".
class NotModelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RelativeModel {
  std::vector<kanec_peer_body> bodies;
  std::vector<int> of;  // the scene's body that each is (from 0), the first of those welded together
  std::array<double, 3> gravity = {};
  int n_q = 0, n_u = 0;

  kanec_peer_model view() const;
};

// Throws NotModelled.
RelativeModel relative_model(const scene::Scene& scene);

}  // namespace kanec
