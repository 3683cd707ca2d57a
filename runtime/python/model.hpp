// Compiled models for Python. Not: how one is made of a scene (scene.cpp), nor what a call does (call.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "kanec/kanec.hpp"

namespace kanec::python {

namespace py = pybind11;

// A kanec.Model of scene.compile(), with the scene's values as its defaults.
py::object make_model(const Scene& scene, const Model& model, const Emission& emission, const Compilation& compilation,
                      int threads);

py::dict dict_of(const std::vector<Quantity>& quantities);

// kanec.Model
void bind_model(py::module_& module);

}  // namespace kanec::python
