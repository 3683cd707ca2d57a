// Kane's equations of a scene, symbolically, from its connection array. Not: how they are printed or turned into code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/equations.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec::symbolic {

// The functions of these names (the usual ones when the list is empty) and what they need. `reactions` and
// `driving_loads` are of the whole mechanism: they take no merging of welds nor dropping of locks. Throws InputError
// for an unknown name. Source of the method: the lecture note named in CONVENTIONS.md.
Equations derive(const scene::Scene& scene, const std::vector<std::string>& functions = {}, const Way& way = {});

// Does this function need a mechanism in which nothing is merged or dropped?
bool needs_whole_mechanism(const std::string& function);

}  // namespace kanec::symbolic
