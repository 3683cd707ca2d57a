// A compiled model's function as an object that Python calls: kanec.Function. Not: the model it is of (model.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "kanec/kanec.hpp"
#include "runtime/python/batches.hpp"

namespace kanec::python {

namespace py = pybind11;

// What a model and its functions share.
struct CompiledScene {
  Evaluator evaluator;  // with the scene's values
  std::shared_ptr<Batches> batches;
  std::vector<std::string> value_names;  // parameters, then inputs
  py::dict value_numbers;                // the place of each
  int threads = 0;
};

struct Callable {
  std::shared_ptr<const CompiledScene> model;
  Function function;
  std::string request;         // "kinematics+accelerations"
  std::vector<Shape> results;  // one a part of the request
  std::vector<long> shape;     // of one state's result: (size), or (rows, columns) of one matrix
  bool is_long = false;        // takes longer than handing over Python's lock
};

py::object make_function(Callable callable);

// kanec.Function
void bind_function(py::module_& module);

}  // namespace kanec::python
