// Kane's equations of a scene, symbolically, from its connection array. Not: how they are printed or turned into code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/equations.hpp"

namespace kanec::symbolic {

// Source of the method: the lecture note named in CONVENTIONS.md. Throws InternalError only.
Equations derive(const scene::Scene& scene);

}  // namespace kanec::symbolic
