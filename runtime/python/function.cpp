// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/function.hpp"

#include <pybind11/stl.h>
#include <structmember.h>

#include <cstddef>
#include <exception>
#include <utility>

#include "runtime/python/call.hpp"
#include "runtime/python/errors.hpp"

namespace kanec::python {
namespace {

// By hand, not by pybind11, whose way to a function costs more than most evaluations.
struct FunctionObject {
  PyObject ob_base;  // what PyObject_HEAD is
  vectorcallfunc vectorcall;
  Callable* callable;
};

const Callable& of(PyObject* self) { return *reinterpret_cast<FunctionObject*>(self)->callable; }

bool is(PyObject* keyword, PyObject* name) { return keyword == name || PyUnicode_Compare(keyword, name) == 0; }

PyObject* given(PyObject* object) { return object == Py_None ? nullptr : object; }

struct Keywords {
  PyObject *x = PyUnicode_InternFromString("x"), *y = PyUnicode_InternFromString("y"),
           *ydot = PyUnicode_InternFromString("ydot"), *t = PyUnicode_InternFromString("t"),
           *out = PyUnicode_InternFromString("out");
};

void set_state(PyObject*& place, PyObject* object, const char* name) {
  if (place != nullptr) throw py::type_error(std::string("found ") + name + " twice");
  place = given(object);
}

void set_value(Arguments& arguments, const Callable& callable, PyObject* keyword, PyObject* object) {
  PyObject* number = PyDict_GetItemWithError(callable.model->value_numbers.ptr(), keyword);
  if (number != nullptr) {
    arguments.values.emplace_back(static_cast<int>(PyLong_AsLong(number)), object);
    return;
  }
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  std::string all = "x, y, ydot, t, out";
  for (const std::string& name : callable.model->value_names) all += ", " + name;
  const py::object near =
      py::module_::import("kanec.errors").attr("nearest")(py::handle(keyword), callable.model->value_names);
  refuse(callable.model->evaluator.model().name() + ", " + callable.function.name,
         "the keyword " + std::string(py::str(py::handle(keyword))), all + std::string(py::str(near)));
}

Arguments arguments_of(const Callable& callable, PyObject* const* args, Py_ssize_t n, PyObject* names) {
  static const Keywords keywords;
  Arguments arguments;
  if (n > 3)
    throw py::type_error(callable.function.name + "() takes x, y and ydot, all else by keyword; found " +
                         std::to_string(n) + " positional arguments");
  for (Py_ssize_t i = 0; i < n; ++i) arguments.state[static_cast<std::size_t>(i)] = given(args[i]);
  const Py_ssize_t n_names = names == nullptr ? 0 : PyTuple_GET_SIZE(names);
  for (Py_ssize_t i = 0; i < n_names; ++i) {
    PyObject *keyword = PyTuple_GET_ITEM(names, i), *object = args[n + i];
    if (is(keyword, keywords.out))
      arguments.out = given(object);
    else if (is(keyword, keywords.t))
      arguments.t = given(object);
    else if (is(keyword, keywords.x))
      set_state(arguments.state[0], object, "x");
    else if (is(keyword, keywords.y))
      set_state(arguments.state[1], object, "y");
    else if (is(keyword, keywords.ydot))
      set_state(arguments.state[2], object, "ydot");
    else
      set_value(arguments, callable, keyword, object);
  }
  return arguments;
}

PyObject* call(PyObject* self, PyObject* const* args, std::size_t n, PyObject* names) noexcept {
  try {
    const Arguments arguments = arguments_of(of(self), args, PyVectorcall_NARGS(n), names);
    return Call(of(self), arguments).result();
  } catch (const py::builtin_exception& error) {
    error.set_error();
  } catch (...) {
    set_python_error();
  }
  return nullptr;
}

void deallocate(PyObject* self) {
  delete reinterpret_cast<FunctionObject*>(self)->callable;
  PyTypeObject* type = Py_TYPE(self);
  type->tp_free(self);
  Py_DECREF(type);
}

// What pybind11 does around a getter.
template <class Make>
PyObject* safely(Make make) noexcept {
  try {
    return py::object(make()).release().ptr();
  } catch (...) {
    set_python_error();
    return nullptr;
  }
}

py::tuple shape_tuple(const Callable& callable) {
  py::tuple shape(callable.shape.size());
  for (std::size_t i = 0; i < callable.shape.size(); ++i) shape[i] = callable.shape[i];
  return shape;
}

py::tuple reads_tuple(const Function& function) {
  py::list names;
  const std::pair<bool, const char*> all[] = {{function.reads_t, "t"},
                                              {function.reads_x, "x"},
                                              {function.reads_y, "y"},
                                              {function.reads_ydot, "ydot"},
                                              {function.reads_inputs, "inputs"}};
  for (const auto& [reads, name] : all)
    if (reads) names.append(name);
  return py::tuple(names);
}

PyObject* get_name(PyObject* self, void*) {
  return safely([&] { return py::str(of(self).function.name); });
}
PyObject* get_shape(PyObject* self, void*) {
  return safely([&] { return shape_tuple(of(self)); });
}
PyObject* get_reads(PyObject* self, void*) {
  return safely([&] { return reads_tuple(of(self).function); });
}

PyObject* get_results(PyObject* self, void*) {
  return safely([&] {
    py::list list;
    for (const Shape& shape : of(self).results) list.append(py::cast(shape));
    return py::tuple(list);
  });
}

PyObject* represent(PyObject* self) {
  return safely([&] {
    const Callable& callable = of(self);
    return py::str("<kanec.Function {} of {}, of {}, returns shape {}>")
        .format(callable.function.name, callable.model->evaluator.model().name(), reads_tuple(callable.function),
                shape_tuple(callable));
  });
}

constexpr const char* doc =
    R"(A function of a compiled model: f(x=None, y=None, ydot=None, *, t=0.0, out=None, **values).

x (nx), y (ny), ydot (ny): one state, or (count, nx) and so on: many states at once, in lanes and threads; what has one
dimension then holds for all of them. What the function does not read may be left out. Arrays of float64 that are
C-contiguous are read where they stand, for many states also those that are all Fortran-ordered (a little faster; so is
the result then), and those that are all float32 (computed in float32, and so is the result). All others are copied.
t [s]: a number, or (count).
values: parameters and inputs by name, for this call alone: numbers, or arrays (count), for each state its own.
out: where to write: float64 (float32 as above), of the result's shape, without gaps, not the memory of an argument.

Returns `shape` of one state, (count, *shape) of many. A matrix has (rows, columns), all else stands in one row, whose
parts `results` names; the results of a combined function stand one after another.

Many states at once are compiled when they are first asked for, which takes a second or more unless the cache has them.
Results differ by rounding from those of single states, and do not depend on the number of threads.

Raises InputError for shapes, kinds of numbers and names that cannot be; BuildError. May be called from several threads at
once; many states at once take turns.)";

PyGetSetDef getters[] = {
    {"name", get_name, nullptr, "\"kinematics_and_accelerations\"", nullptr},
    {"shape", get_shape, nullptr, "Of one state's result: (size,), or (rows, columns) of a matrix.", nullptr},
    {"reads", get_reads, nullptr, "Which of t, x, y, ydot and inputs it reads.", nullptr},
    {"results", get_results, nullptr, "What the numbers of a result are: a Shape for each part of a combined function.",
     nullptr},
    {nullptr, nullptr, nullptr, nullptr, nullptr}};

PyMemberDef members[] = {{"__vectorcalloffset__", T_PYSSIZET, offsetof(FunctionObject, vectorcall), READONLY, nullptr},
                         {nullptr, 0, 0, 0, nullptr}};

PyType_Slot slots[] = {{Py_tp_dealloc, reinterpret_cast<void*>(deallocate)},
                       {Py_tp_call, reinterpret_cast<void*>(PyVectorcall_Call)},
                       {Py_tp_repr, reinterpret_cast<void*>(represent)},
                       {Py_tp_getset, getters},
                       {Py_tp_members, members},
                       {Py_tp_doc, const_cast<char*>(doc)},
                       {0, nullptr}};

PyType_Spec spec = {"kanec.Function", sizeof(FunctionObject), 0,
                    Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};

// As long as the interpreter.
PyTypeObject* type() {
  static PyObject* const made = PyType_FromSpec(&spec);
  if (made == nullptr) throw py::error_already_set();
  return reinterpret_cast<PyTypeObject*>(made);
}

}  // namespace

py::object make_function(Callable callable) {
  auto owned = std::make_unique<Callable>(std::move(callable));
  auto* object = PyObject_New(FunctionObject, type());
  if (object == nullptr) throw py::error_already_set();
  object->vectorcall = call;
  object->callable = owned.release();
  return py::reinterpret_steal<py::object>(reinterpret_cast<PyObject*>(object));
}

void bind_function(py::module_& module) {
  module.attr("Function") = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(type()));
}

}  // namespace kanec::python
