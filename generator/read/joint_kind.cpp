// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/joint_kind.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"

namespace kanec::scene {
namespace {

using KeyList = std::vector<std::string>;

KeyList joined(KeyList a, const KeyList& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const KeyList& frames() {
  static const KeyList keys = {"frame_on_lower", "frame_on_body"};
  return keys;
}

// A load along the only coordinate.
const KeyList& load() {
  static const KeyList keys = {"effort", "stiffness", "damping", "rest"};
  return keys;
}

}  // namespace

bool JointKind::takes(const std::string& key) const { return std::find(keys.begin(), keys.end(), key) != keys.end(); }

std::vector<std::string> JointKind::initial_keys() const {
  KeyList out;
  if (ball) out = {"eps", "omega"};
  if (turns > 0) out = {"theta", "thetadot"};
  return slides > 0 ? joined(out, {"s", "sdot"}) : out;
}

std::vector<std::string> JointKind::motion_keys() const {
  KeyList out;
  if (ball) out = {"eps"};
  if (turns > 0) out = {"theta"};
  return slides > 0 ? joined(out, {"s"}) : out;
}

const std::vector<JointKind>& joint_kinds() {
  static const std::vector<JointKind> kinds = {
      {"free", true, 0, 3, {"frame_on_lower"}},
      {"ball", true, 0, 0, {}},
      {"revolute", false, 1, 0, joined(joined({"axis"}, frames()), load())},
      {"universal", false, 2, 0, joined({"axes"}, frames())},
      {"gimbal", false, 3, 0, joined({"axes"}, frames())},
      {"prismatic", false, 0, 1, joined(joined({"axis"}, frames()), load())},
      {"cartesian", false, 0, 3, joined({"axes"}, frames())},
      {"cylindrical", false, 1, 1, joined({"axis"}, frames())},
      {"planar", false, 1, 2, joined({"axis", "axes"}, frames())},
      {"bearing", true, 0, 1, {"axis", "frame_on_lower"}},
      {"screw", false, 1, 0, joined(joined({"axis", "pitch"}, frames()), load())},
      {"weld", false, 0, 0, frames()},
  };
  return kinds;
}

const JointKind& joint_kind(const std::string& name) {
  for (const JointKind& kind : joint_kinds())
    if (kind.name == name) return kind;
  throw InternalError("no joint is of the kind " + name);
}

const std::vector<std::string>& joint_keys() {
  static const KeyList keys = joined({"axis", "axes", "pitch"}, joined(frames(), load()));
  return keys;
}

}  // namespace kanec::scene
