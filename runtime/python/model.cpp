// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/model.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <set>
#include <span>
#include <utility>

#include "kanec/abi.h"
#include "runtime/python/errors.hpp"
#include "runtime/python/function.hpp"

namespace kanec::python {
namespace {

// One that takes longer than handing over Python's lock: some microseconds.
constexpr long many_operations = 20000;

struct CompiledModel {
  Model model;
  std::shared_ptr<const CompiledScene> shared;
};

using Names = std::set<std::string, std::less<>>;

// "kinematics+accelerations" of "kinematics_and_accelerations", where all parts are functions; else empty.
std::string request_of(const std::string& word, const Names& functions) {
  if (functions.contains(word)) return word;
  static constexpr std::string_view joint = "_and_";
  for (std::size_t at = word.find(joint); at != word.npos; at = word.find(joint, at + 1)) {
    if (!functions.contains(word.substr(0, at))) continue;
    const std::string rest = request_of(word.substr(at + joint.size()), functions);
    if (!rest.empty()) return word.substr(0, at) + "+" + rest;
  }
  return "";
}

std::vector<long> result_shape(const Function& function, const std::vector<Shape>& results) {
  if (results.size() == 1 && results[0].parts.size() == 1 && results[0].parts[0].shape.size() == 2)
    return {results[0].parts[0].shape.begin(), results[0].parts[0].shape.end()};
  return {function.size};
}

bool takes_long(const Model& model, const Function& function) {
  const kanec_function& f = model.abi().functions[function.number];
  return long{f.adds} + f.multiplies + f.divides + f.square_roots + f.trigonometric + f.other_functions >
         many_operations;
}

std::vector<Callable> callables(const Scene& scene, const Model& model,
                                const std::shared_ptr<const CompiledScene>& shared) {
  const py::gil_scoped_release unlocked;
  Names names;
  for (const Offer& offer : scene.functions()) names.insert(offer.name);
  std::vector<Callable> list;
  for (const Function& function : model.functions()) {
    const std::string request = request_of(function.name, names);
    std::vector<Shape> results = request.empty() ? std::vector<Shape>{} : scene.results(request);
    std::vector<long> shape = result_shape(function, results);
    list.push_back({shared, function, request.empty() ? function.name : request, std::move(results), std::move(shape),
                    takes_long(model, function)});
  }
  return list;
}

py::dict named(std::span<const double> values, const std::vector<Quantity>& names) {
  py::dict dict;
  for (std::size_t i = 0; i < names.size(); ++i) dict[py::str(names[i].name)] = values[i];
  return dict;
}

py::object function_of(const py::object& self, const std::string& request) {
  const Model& model = self.cast<const CompiledModel&>().model;
  return self.attr("__dict__")[py::str(model.function(request).name)];
}

py::dict functions_of(const py::object& self) {
  py::dict dict;
  for (const Function& function : self.cast<const CompiledModel&>().model.functions())
    dict[py::str(function.name)] = function_of(self, function.name);
  return dict;
}

[[noreturn]] void refuse_attribute(const CompiledModel& self, const std::string& name) {
  std::vector<std::string> names;
  for (const Function& function : self.model.functions()) names.push_back(function.name);
  const py::object near = py::module_::import("kanec.errors").attr("nearest")(name, names);
  throw py::attribute_error("model " + self.model.name() + " has no function " + name + std::string(py::str(near)));
}

std::string model_representation(const CompiledModel& self) {
  std::string functions;
  for (const Function& function : self.model.functions()) functions += (functions.empty() ? "" : ", ") + function.name;
  return "<kanec.Model " + self.model.name() + ", nx " + std::to_string(self.model.nx()) + ", ny " +
         std::to_string(self.model.ny()) + ": " + functions + ">";
}

}  // namespace

py::dict dict_of(const std::vector<Quantity>& quantities) {
  py::dict dict;
  for (const Quantity& quantity : quantities) dict[py::str(quantity.name)] = quantity.value;
  return dict;
}

py::object make_model(const Scene& scene, const Model& model, const Emission& emission, const Compilation& compilation,
                      int threads) {
  auto shared = std::make_shared<CompiledScene>(CompiledScene{
      Evaluator(model), std::make_shared<Batches>(scene, emission, compilation, threads), {}, {}, threads});
  for (const auto& list : {model.parameters(), model.inputs()})
    for (const Quantity& quantity : list) {
      shared->value_numbers[py::str(quantity.name)] = shared->value_names.size();
      shared->value_names.push_back(quantity.name);
    }
  const py::object object = py::cast(std::make_shared<CompiledModel>(CompiledModel{model, shared}));
  for (Callable& callable : callables(scene, model, shared)) {
    const std::string name = callable.function.name;
    object.attr("__dict__")[py::str(name)] = make_function(std::move(callable));
  }
  return object;
}

void bind_model(py::module_& module) {
  py::class_<CompiledModel, std::shared_ptr<CompiledModel>>(module, "Model", py::dynamic_attr(),
                                                            R"(A compiled model, made by Scene.compile().

Its functions are its attributes, model.accelerations(x, y), and found by name, model["kinematics+accelerations"]; dir()
lists them, and help(kanec.Function) says how they are called. May be used from several threads at once.)")
      .def_property_readonly(
          "name", [](const CompiledModel& self) { return self.model.name(); }, "The scene's name.")
      .def_property_readonly(
          "hash", [](const CompiledModel& self) { return self.model.hash(); },
          "Of scene, generator and options: 16 hexadecimal digits.")
      .def_property_readonly(
          "nx", [](const CompiledModel& self) { return self.model.nx(); }, "Number of coordinates.")
      .def_property_readonly(
          "ny", [](const CompiledModel& self) { return self.model.ny(); }, "Number of speeds.")
      .def_property_readonly(
          "threads", [](const CompiledModel& self) { return self.shared->threads; },
          "That many states at once are computed in; 0: one a processor.")
      .def_property_readonly(
          "coordinates", [](const CompiledModel& self) { return self.model.coordinates(); },
          "Names of the entries of x (nx): \"theta_3\".")
      .def_property_readonly(
          "speeds", [](const CompiledModel& self) { return self.model.speeds(); },
          "Names of the entries of y (ny): \"thetadot_3\".")
      .def_property_readonly(
          "parameters",
          [](const CompiledModel& self) { return named(self.shared->evaluator.parameters(), self.model.parameters()); },
          "Those that its functions read, by name, with the values that hold unless a call gives others.")
      .def_property_readonly(
          "inputs",
          [](const CompiledModel& self) { return named(self.shared->evaluator.inputs(), self.model.inputs()); },
          "As parameters.")
      .def_property_readonly("functions", functions_of, "Its functions by name.")
      .def("__getitem__", function_of, py::arg("request"),
           "The function of that name, with + or _and_ between the parts of a combined one. Raises InputError.")
      .def("__getattr__", refuse_attribute)
      .def("__repr__", model_representation);
}

}  // namespace kanec::python
