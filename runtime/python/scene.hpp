// Scenes for Python, and what their states and results are. Not: compiled models (model.hpp), motions (motion.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace kanec::python {

// kanec.Part, kanec.Shape, kanec.Offer
void bind_shapes(pybind11::module_& module);

// kanec.Scene, kanec.Agreed, kanec.read(), parse(), build() and tree()
void bind_scene(pybind11::module_& module);

}  // namespace kanec::python
