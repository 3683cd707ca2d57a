// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/motion.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <utility>
#include <vector>

#include "runtime/python/arrays.hpp"
#include "runtime/python/errors.hpp"
#include "runtime/python/model.hpp"

namespace kanec::python {
namespace {

struct Event {
  std::string name;
  double t = 0.0;
  bool up = false;
};

struct NamedMotion {
  Motion motion;
  Model model;
  std::vector<Event> events;
};

// The numbers where they stand; the motion lives as long as the array.
py::object view(const py::object& self, const std::vector<double>& numbers, std::vector<npy_intp> shape) {
  auto array = py::reinterpret_steal<py::object>(PyArray_SimpleNewFromData(
      static_cast<int>(shape.size()), shape.data(), NPY_DOUBLE, const_cast<double*>(numbers.data())));
  if (!array) throw py::error_already_set();
  if (PyArray_SetBaseObject(array_of(array), py::object(self).release().ptr()) != 0) throw py::error_already_set();
  return array;
}

// (rows), or (rows × n).
template <class Choose>
auto column(Choose choose, int Motion::*width = nullptr) {
  return [choose, width](const py::object& self) -> py::object {
    const Motion& motion = self.cast<const NamedMotion&>().motion;
    const std::vector<double>& numbers = choose(motion);
    const auto rows = static_cast<npy_intp>(motion.rows());
    if (width != nullptr) return view(self, numbers, {rows, motion.*width});
    if (numbers.size() != motion.rows()) return py::none();
    return view(self, numbers, {rows});
  };
}

std::string motion_representation(const NamedMotion& self) {
  const Motion& motion = self.motion;
  return "<kanec.Motion of " + self.model.name() + ": " + std::to_string(motion.rows()) + " rows, " +
         std::to_string(motion.steps) + " steps" + (motion.stopped ? ", stopped by an event>" : ">");
}

py::dict inputs_of(const NamedMotion& self) {
  py::dict dict;
  const std::vector<Quantity> inputs = self.model.inputs();
  for (std::size_t i = 0; i < inputs.size(); ++i) dict[py::str(inputs[i].name)] = self.motion.inputs[i];
  return dict;
}

void bind_event(py::module_& module) {
  py::class_<Event>(module, "Event", "Something that happened during a run: an [[event]] of the scene.")
      .def_readonly("name", &Event::name, "Of the [[event]].")
      .def_readonly("t", &Event::t, "When [s].")
      .def_readonly("up", &Event::up, "Whether its expression went through zero upwards.")
      .def("__repr__", [](const Event& self) {
        return py::str("<kanec.Event {} at t = {} s, {}>").format(self.name, self.t, self.up ? "upwards" : "downwards");
      });
}

}  // namespace

void apply(const RunChange& change, Run& run) {
  const auto set = [](auto& setting, const auto& given) {
    if (given) setting = *given;
  };
  set(run.duration, change.duration);
  set(run.output_step, change.output_step);
  set(run.step, change.step);
  set(run.longest_step, change.longest_step);
  set(run.relative_tolerance, change.rtol);
  set(run.absolute_tolerance, change.atol);
  set(run.integrator, change.integrator);
  set(run.jacobian, change.jacobian);
  set(run.order, change.order);
}

py::dict dict_of(const Run& run) {
  using namespace py::literals;
  return py::dict("duration"_a = run.duration, "output_step"_a = run.output_step, "integrator"_a = run.integrator,
                  "step"_a = run.step, "longest_step"_a = run.longest_step, "rtol"_a = run.relative_tolerance,
                  "atol"_a = run.absolute_tolerance, "order"_a = run.order, "jacobian"_a = run.jacobian);
}

py::object simulated(const Scene& scene, const py::object& x, const py::object& y, const Run& run,
                     Compilation compilation) {
  const std::vector<double> x_0 = x.is_none() ? scene.initial_x() : numbers(x.ptr(), scene.nx(), scene.name() + ": x");
  const std::vector<double> y_0 = y.is_none() ? scene.initial_y() : numbers(y.ptr(), scene.ny(), scene.name() + ": y");
  std::shared_ptr<NamedMotion> made;
  {
    const py::gil_scoped_release unlocked;
    Emission emission;
    emission.functions = scene.functions_to_simulate(run);
    emission.taylor = needs_taylor(run);
    compilation.poll = watch_for_signals();
    const Evaluator evaluator(scene.compile(emission, compilation));
    Motion motion = simulate(evaluator, x_0, y_0, run, [poll = compilation.poll](double) { poll(); });
    made = std::make_shared<NamedMotion>(NamedMotion{std::move(motion), evaluator.model(), {}});
    for (const Happening& one : made->motion.happenings)
      made->events.push_back({run.events[static_cast<std::size_t>(one.event)].name, one.t, one.up});
  }
  return py::cast(made);
}

void bind_motion(py::module_& module) {
  bind_event(module);
  const auto of = [](auto member) { return [member](const NamedMotion& self) { return self.motion.*member; }; };
  const auto list = [](std::vector<double> Motion::*member) {
    return [member](const Motion& motion) -> const std::vector<double>& { return motion.*member; };
  };
  py::class_<NamedMotion, std::shared_ptr<NamedMotion>>(module, "Motion", R"(Rows of a run, the first at t = 0.

Its arrays are float64 and are not copied.)")
      .def_property_readonly("t", column(list(&Motion::t)), "Times [s] (rows).")
      .def_property_readonly("x", column(list(&Motion::x), &Motion::nx), "Coordinates (rows, nx).")
      .def_property_readonly("y", column(list(&Motion::y), &Motion::ny), "Speeds (rows, ny).")
      .def_property_readonly("work", column(list(&Motion::work)), "Of the applied loads since t = 0 [J] (rows).")
      .def_property_readonly("kinetic", column(list(&Motion::kinetic)), "Kinetic energy [J] (rows).")
      .def_property_readonly("potential", column(list(&Motion::potential)), "Potential energy [J] (rows).")
      .def_property_readonly(
          "coordinates", [](const NamedMotion& self) { return self.model.coordinates(); }, "Names of the columns of x.")
      .def_property_readonly(
          "speeds", [](const NamedMotion& self) { return self.model.speeds(); }, "Names of the columns of y.")
      .def_property_readonly("inputs", inputs_of, "By name, at the end: events set them.")
      .def_readonly("events", &NamedMotion::events, "What happened, in order: a list of Event.")
      .def_property_readonly("stopped", of(&Motion::stopped), "Whether by an event, before the duration.")
      .def_property_readonly("steps", of(&Motion::steps), "Steps taken.")
      .def_property_readonly("failed_steps", of(&Motion::failed_steps), "Steps that were tried again, shorter.")
      .def_property_readonly("evaluations", of(&Motion::evaluations), "Of the rates of the state.")
      .def_property_readonly("wall_seconds", of(&Motion::wall_seconds), "What it took [s], without compilation.")
      .def_property_readonly("energy_error", of(&Motion::energy_error),
                             "Worst change of energy less work, relative to the energies' own size; None if not known.")
      .def_property_readonly("norm_error", of(&Motion::norm_error), "Worst | |eps| - 1 | before it was projected.")
      .def("__len__", [](const NamedMotion& self) { return self.motion.rows(); })
      .def("__repr__", motion_representation);
}

}  // namespace kanec::python
