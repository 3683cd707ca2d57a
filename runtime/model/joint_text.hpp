// The joint of a body as keys of its TOML table: kind, axes, frames, how it begins, what is locked or prescribed. Not:
// the rest of the body (scene_text.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <string>

#include "generator/scene/scene.hpp"

namespace kanec {

// A TOML float, which has a point or an exponent, and a list of them; both read back exactly.
std::string toml_real(double value);
std::string toml_list(std::span<const double> values);

// Keys of [[body]]. Axes read back exactly where some multiple of a unit vector in double precision does; the frame on
// the body to rounding.
std::string joint_text(const scene::Joint& joint);
// [body.initial] and [body.motion]; empty tables are left out.
std::string motion_text(const scene::Scene& scene, const scene::Body& body);

}  // namespace kanec
