// The scene as a mechanism: links (bodies that move as one) and the freedoms between them. Not here: equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::symbolic {

// What is left out before anything is derived. Each is exact; switching one off costs operations and changes no result.
struct Reductions {
  bool merge_welds = true;  // bodies that do not move against each other become one link
  bool drop_locks = true;   // a locked coordinate is a constant of the geometry, not a coordinate with a constant value
  bool place_origins = true;  // origins moved along the axes of turns, so that offsets have zeros
  bool regroup = true;        // what a joint cannot feel of a link's mass and inertia belongs to the lower link
  bool turn_axes = true;      // axes of last links turned about their joints, so that mass centres have zeros
  int group = any_number;     // of how many links' masses one holds then; on long chains few cost fewer digits

  static constexpr int any_number = 1 << 30;
  bool operator==(const Reductions&) const = default;
};

// A constant vector: Σ orientation · numbers.
struct OffsetTerm {
  scene::Rotation orientation = scene::no_rotation;
  scene::Vector numbers;
};
using Offset = std::vector<OffsetTerm>;

// One coordinate of a joint, or three that belong together.
struct Freedom {
  enum class Kind { attitude, turn, translation, slide };
  Kind kind = Kind::turn;
  int coordinate = 0;     // of the joint's turns or slides, from 0
  scene::Axis axis = {};  // of a turn: in the lower link's axes at zero angle; of a slide: in the lower link's axes
};

struct Link {
  enum class Turning { ball, held, turn, fixed };
  int body = 0;        // K, whose joint moves it
  int lower = 0;       // link; 0 = inertial frame
  std::string suffix;  // of its letters: "3", or "3a", "3b" of the frames between the turns of a joint
  Turning turning = Turning::fixed;
  std::vector<Freedom> freedoms;  // rotation first
  scene::Rotation zero =
      scene::no_rotation;  // link to lower link components at zero angle; of a held ball to inertial ones
  Offset offset;           // of its origin from the lower link's, without slides; lower link's axes
  double pitch = 0.0;      // of its turn [m/rad]
  std::optional<scene::Axis> centre = {};  // mass centre, link axes [m], where these are turned for its sake
};

// Where a body of the scene is on its link.
struct BodyPlace {
  int link = 0;
  scene::Rotation orientation = scene::no_rotation;  // body to link components
  Offset offset;                                     // of its origin from the link's, link axes
};

struct Mechanism {
  std::vector<Link> links;        // link j of the text is links[j - 1]
  std::vector<BodyPlace> bodies;  // of body K: bodies[K - 1]

  int size() const { return static_cast<int>(links.size()); }
  const Link& link(int j) const { return links[static_cast<std::size_t>(j - 1)]; }
  const BodyPlace& body(int k) const { return bodies[static_cast<std::size_t>(k - 1)]; }
  std::vector<int> children(int link) const;  // links on it, ascending; 0: on the inertial frame
  std::vector<int> carried(int link) const;   // bodies on it, ascending
  bool has_balls() const;                     // between links, not on the inertial frame
};

Mechanism mechanism(const scene::Scene& scene, const Reductions& reductions);

// Which coordinate axis a unit vector lies along, either way; -1: none.
int coordinate_axis(const scene::Axis& a);

bool is_identity(const scene::Rotation& a);
scene::Rotation product(const scene::Rotation& a, const scene::Rotation& b);
scene::Axis turned(const scene::Rotation& a, const scene::Axis& v);
scene::Rotation rotation_about(const scene::Axis& axis, double angle);

}  // namespace kanec::symbolic
