// From the keys of [[body]] to a joint. Not: its initial state and its motion (read_motion.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/joint_kind.hpp"
#include "generator/read/node.hpp"
#include "generator/scene/joint.hpp"

namespace kanec::scene {

// The kind that the body's key `joint` names; free where there is none. Throws SceneError.
const JointKind& read_joint_kind(const Table& body);

// Its axes in L(K)'s axes, `zero` and pitch. Appends a note where a rotation was rounded. Throws SceneError.
Joint read_joint(const Table& body, const JointKind& kind, std::vector<std::string>& notes);

}  // namespace kanec::scene
