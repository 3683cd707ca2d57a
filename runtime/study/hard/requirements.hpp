// What answers ask of a scene and of a start, and the messages where it is not there. Not: the answers (answer.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "generator/scene/scene.hpp"

namespace kanec::hard {

// All throw InputError, "ANSWER: found FOUND; allowed: ALLOWED".
[[noreturn]] void refuse(const std::string& answer, const std::string& found, const std::string& allowed);
[[noreturn]] void refuse_scene(const std::string& answer, const std::string& allowed);

// Refuses slides that are locked or prescribed, of any body: they have no place in x.
void refuse_bound_slides(const std::string& answer, const scene::Layout& layout, const std::string& allowed);

// Of the only body, which has so many slides, all free.
scene::BodyLayout sliding_mass(const std::string& answer, const scene::Scene& scene, std::size_t n_slides,
                               const std::string& allowed);

// The default of a parameter.
long double parameter(const std::string& answer, const scene::Scene& scene, const std::string& name);

}  // namespace kanec::hard
