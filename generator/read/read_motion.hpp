// How the joint of a body begins to move, and what of it is locked or prescribed. Not: the joint itself
// (read_joint.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/joint_kind.hpp"
#include "generator/read/node.hpp"
#include "generator/read/parse_expression.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// [body.initial]: attitude of a ball, values and rates of turns and slides. Appends a note where Euler parameters were
// far from unit norm. Throws SceneError.
void read_initial(const Table& body_table, const JointKind& kind, Body& body, std::vector<std::string>& notes);

// [body.motion] of body k, after its initial state. Appends to the scene's expressions. Throws SceneError.
void read_motion(const Table& body_table, const JointKind& kind, int k, const std::vector<ExpressionName>& names,
                 Scene& scene);

}  // namespace kanec::scene
