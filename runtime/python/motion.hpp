// A run and its motion for Python. Not: the scene that moves (scene.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>

#include "kanec/kanec.hpp"

namespace kanec::python {

namespace py = pybind11;

// Those settings of a run that are given in place of the scene's.
struct RunChange {
  std::optional<double> duration, output_step, step, longest_step, rtol, atol;
  std::optional<std::string> integrator, jacobian;
  std::optional<int> order;
};

void apply(const RunChange& change, Run& run);
py::dict dict_of(const Run& run);

// From x and y, or where they are None from the scene's own initial state.
py::object simulated(const Scene& scene, const py::object& x, const py::object& y, const Run& run,
                     Compilation compilation);

// kanec.Motion, kanec.Event
void bind_motion(py::module_& module);

}  // namespace kanec::python
