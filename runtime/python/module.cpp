// The module kanec._kanec: what it binds. Not: the package around it (kanec/__init__.py).
// SPDX-License-Identifier: GPL-2.0-or-later
#define KANEC_IMPORTS_ARRAYS
#include <pybind11/stl.h>

#include "kanec/kanec.hpp"
#include "runtime/python/arrays.hpp"
#include "runtime/python/errors.hpp"
#include "runtime/python/function.hpp"
#include "runtime/python/model.hpp"
#include "runtime/python/motion.hpp"
#include "runtime/python/scene.hpp"

PYBIND11_MODULE(_kanec, module) {
  using namespace kanec::python;
  if (_import_array() < 0) throw py::error_already_set();
  module.doc() = "Scenes, compiled models and motions: what kanec makes public.";
  module.attr("__version__") = kanec::library_version();
  register_errors();
  bind_shapes(module);
  bind_function(module);
  bind_model(module);
  bind_motion(module);
  bind_scene(module);
  module.def("integrators", &kanec::integrators, "Names of the integrators of Scene.simulate().");
}
