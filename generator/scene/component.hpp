// The scalar components of all joints, in the state or not, and the names they go by. Not: their places in x and y.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::scene {

// One component of a joint: of the attitude of a ball, one of its turns or one of its slides.
struct Component {
  enum class Kind { attitude, turn, slide };
  Kind kind = Kind::attitude;
  int body = 0;   // from 1
  int index = 0;  // from 0
  int count = 1;  // how many of this kind the joint has
};

// Kind by kind for each body. Speeds: 3 components of ω for the 4 Euler parameters of an attitude.
std::vector<Component> components(const Scene& scene);
std::vector<Component> speed_components(const Scene& scene);

// "theta_3", "s_2_1", "eps_1_4"; with the body's name in place of its number: "theta_elbow", "s_cart", "eps_hub_4".
std::string coordinate_name(const Component& component);
std::string coordinate_name_by_body(const Scene& scene, const Component& component);

// "thetadot_3", "sdot_2_1", "omega_1_3"; by body: "thetadot_elbow".
std::string speed_name(const Component& component);
std::string speed_name_by_body(const Scene& scene, const Component& component);

// Its entry of x and of y, or -1 where its motion is locked or prescribed. Of an attitude, x by its Euler parameter and
// y by its component of ω.
int index_in_x(const Layout& layout, const Component& component);
int index_in_y(const Layout& layout, const Component& component);

// The turn or slide; none of an attitude.
const Coordinate* coordinate_of(const Scene& scene, const Component& component);

}  // namespace kanec::scene
