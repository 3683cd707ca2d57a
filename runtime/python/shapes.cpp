// SPDX-License-Identifier: GPL-2.0-or-later
#include <pybind11/stl.h>

#include "kanec/scene.hpp"
#include "runtime/python/arrays.hpp"
#include "runtime/python/errors.hpp"
#include "runtime/python/scene.hpp"

namespace kanec::python {
namespace {

py::tuple tuple_of(const std::vector<int>& list) {
  py::tuple tuple(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) tuple[i] = list[i];
  return tuple;
}

// Views of the parts, their own shape last.
py::dict split(const Shape& self, const py::object& given) {
  py::object array = as_array(given.ptr(), self.name);
  std::vector<npy_intp> shape = shape_of(array_of(array));
  const bool is_matrix = self.parts.size() == 1 && self.parts[0].shape.size() == 2;
  if (is_matrix && shape.size() >= 2 && shape.back() == self.parts[0].shape[1] &&
      shape[shape.size() - 2] == self.parts[0].shape[0]) {
    py::dict dict;
    dict[py::str(self.parts[0].name)] = array;
    return dict;
  }
  if (shape.empty() || shape.back() != self.size)
    refuse(self.name, description(array.ptr()), "the last of its dimensions " + std::to_string(self.size));
  shape.pop_back();
  py::dict dict;
  for (const Part& part : self.parts) {
    const py::object some = array[py::make_tuple(py::ellipsis(), py::slice(part.begin, part.begin + part.size, 1))];
    py::list dimensions;
    for (const npy_intp n : shape) dimensions.append(n);
    for (const int n : part.shape) dimensions.append(n);
    dict[py::str(part.name)] = some.attr("reshape")(py::tuple(dimensions));
  }
  return dict;
}

py::tuple reads_of(const Offer& offer) {
  py::list names;
  if (offer.reads_t) names.append("t");
  if (offer.reads_x) names.append("x");
  if (offer.reads_y) names.append("y");
  if (offer.reads_ydot) names.append("ydot");
  if (offer.reads_inputs) names.append("inputs");
  return py::tuple(names);
}

}  // namespace

void bind_shapes(py::module_& module) {
  py::class_<Part>(module, "Part", "Numbers that belong together, in a state or a result.")
      .def_readonly("name", &Part::name, "\"eps_1\"")
      .def_property_readonly(
          "shape", [](const Part& self) { return tuple_of(self.shape); },
          "() of a number, (n,) of a list, (rows, columns) of a matrix.")
      .def_readonly("unit", &Part::unit, "\"rad/s\"")
      .def_readonly("begin", &Part::begin, "Its first number, counted from 0.")
      .def_readonly("size", &Part::size, "How many numbers it has.")
      .def("__repr__", [](const Part& self) {
        return py::str("<kanec.Part {} {} [{}] at {}>").format(self.name, tuple_of(self.shape), self.unit, self.begin);
      });
  py::class_<Shape>(module, "Shape", "What the numbers of a state or a result are, in order.")
      .def_readonly("name", &Shape::name, "\"x\", \"mass_matrix\"")
      .def_readonly("parts", &Shape::parts, "A list of Part.")
      .def_readonly("rows", &Shape::rows, "Names of the rows of a matrix.")
      .def_readonly("columns", &Shape::columns, "Names of the columns of a matrix.")
      .def_readonly("size", &Shape::size, "How many numbers.")
      .def("split", split, py::arg("array"),
           "The parts of an array of that shape (..., size) by name, without copying where NumPy can. Raises "
           "InputError.")
      .def("__repr__", [](const Shape& self) {
        py::list names;
        for (const Part& part : self.parts) names.append(part.name);
        return py::str("<kanec.Shape {} ({}): {}>").format(self.name, self.size, py::str(", ").attr("join")(names));
      });
  py::class_<Offer>(module, "Offer", "A function that a compiled model of the scene can have.")
      .def_readonly("name", &Offer::name, "\"accelerations\"")
      .def_readonly("meaning", &Offer::meaning, "What it returns.")
      .def_readonly("result", &Offer::result, "A Shape.")
      .def_property_readonly("reads", reads_of, "Which of t, x, y, ydot and inputs it reads.")
      .def_readonly("usual", &Offer::usual, "Whether it is compiled unless functions are named.")
      .def("__repr__", [](const Offer& self) { return "<kanec.Offer " + self.name + ": " + self.meaning + ">"; });
}

}  // namespace kanec::python
