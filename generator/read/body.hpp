// One [[body]] table to a Body: name, mass, joint, beginning. Not: what needs all bodies: motions (read_motion.hpp) and
// loads (read_load.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/joint_kind.hpp"
#include "generator/read/node.hpp"
#include "generator/read/symbols.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// A table of [[body]] whose messages name the body, "body 3 (arm)".
struct BodyTable {
  Table table;
  std::string name;
  const JointKind* kind = nullptr;
};

// That of body `k` (from 1), its keys checked. Throws SceneError.
BodyTable read_body_table(const Node& node, int k);

// Appends to the scene's notes. Throws SceneError.
Body read_body(const BodyTable& from, Symbols& symbols, Scene& scene);

}  // namespace kanec::scene
