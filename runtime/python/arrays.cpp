// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/arrays.hpp"

#include "runtime/python/errors.hpp"

namespace kanec::python {
namespace {

std::string type_name(PyObject* object) { return Py_TYPE(object)->tp_name; }

py::object steal_array(PyObject* object, const std::string& what, const std::string& found) {
  if (object != nullptr) return py::reinterpret_steal<py::object>(object);
  if (PyErr_ExceptionMatches(PyExc_MemoryError) || PyErr_ExceptionMatches(PyExc_KeyboardInterrupt))
    throw py::error_already_set();
  PyErr_Clear();
  refuse(what, found, "an array of real numbers");
}

py::object borrowed(PyArrayObject* array) {
  return py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(array));
}

py::object copied(PyArrayObject* array, int type, int flags, const std::string& what) {
  const std::string found = description(reinterpret_cast<PyObject*>(array));
  const char kind = PyArray_DESCR(array)->kind;
  if (kind != 'f' && kind != 'i' && kind != 'u') refuse(what, found, "real numbers");
  return steal_array(PyArray_FromArray(array, PyArray_DescrFromType(type), flags | NPY_ARRAY_FORCECAST), what, found);
}

}  // namespace

std::string shape_text(const std::vector<npy_intp>& shape) {
  std::string text;
  for (const npy_intp n : shape) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

std::vector<npy_intp> shape_of(PyArrayObject* array) {
  return {PyArray_DIMS(array), PyArray_DIMS(array) + PyArray_NDIM(array)};
}

std::string description(PyObject* object) {
  if (!PyArray_Check(object)) return "a " + type_name(object);
  auto* array = reinterpret_cast<PyArrayObject*>(object);
  const auto type = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(PyArray_DESCR(array)));
  return "an array of " + std::string(py::str(type)) + ", shape " + shape_text(shape_of(array));
}

py::object as_array(PyObject* object, const std::string& what) {
  if (PyArray_Check(object)) return py::reinterpret_borrow<py::object>(object);
  if (PyUnicode_Check(object) || PyBytes_Check(object) || PyDict_Check(object) || PyAnySet_Check(object))
    refuse(what, description(object), "an array of real numbers");
  return steal_array(PyArray_FromAny(object, nullptr, 0, 0, 0, nullptr), what, description(object));
}

py::object converted(PyArrayObject* array, int type, const std::string& what) {
  if (PyArray_TYPE(array) == type && PyArray_ISCARRAY_RO(array)) return borrowed(array);
  return copied(array, type, NPY_ARRAY_CARRAY_RO, what);
}

py::object converted_by_entries(PyArrayObject* array, int type, const std::string& what) {
  if (PyArray_TYPE(array) == type && entry_after_entry(array)) return borrowed(array);
  return copied(array, type, NPY_ARRAY_FARRAY_RO, what);
}

PyObject* new_array(const std::vector<npy_intp>& shape, int type) {
  PyObject* array = PyArray_SimpleNew(static_cast<int>(shape.size()), const_cast<npy_intp*>(shape.data()), type);
  if (array == nullptr) throw py::error_already_set();
  return array;
}

double number(PyObject* object, const std::string& what) {
  if (PyFloat_Check(object)) return PyFloat_AS_DOUBLE(object);
  if (PyArray_Check(object) && PyArray_NDIM(reinterpret_cast<PyArrayObject*>(object)) == 0) {
    const py::object array = converted(reinterpret_cast<PyArrayObject*>(object), NPY_DOUBLE, what);
    return *static_cast<const double*>(PyArray_DATA(array_of(array)));
  }
  const bool is_real = PyLong_Check(object) || PyArray_IsScalar(object, Integer) || PyArray_IsScalar(object, Floating);
  if (!is_real || PyBool_Check(object)) refuse(what, description(object), "a number");
  const double value = PyFloat_AsDouble(object);
  if (value == -1.0 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(what, "an integer beyond all numbers", "a number");
  }
  return value;
}

std::vector<double> numbers(PyObject* object, int count, const std::string& what) {
  const py::object given = as_array(object, what);
  if (PyArray_NDIM(array_of(given)) != 1 || PyArray_DIM(array_of(given), 0) != count)
    refuse(what, description(given.ptr()), "shape " + shape_text({count}));
  const py::object array = converted(array_of(given), NPY_DOUBLE, what);
  const auto* data = static_cast<const double*>(PyArray_DATA(array_of(array)));
  return {data, data + count};
}

bool entry_after_entry(PyArrayObject* array) {
  if (!PyArray_ISALIGNED(array) || !PyArray_ISNOTSWAPPED(array)) return false;
  npy_intp stride = PyArray_ITEMSIZE(array);
  const auto stands = [&](int axis) {
    const npy_intp size = PyArray_DIM(array, axis);
    const bool right = size <= 1 || PyArray_STRIDE(array, axis) == stride;
    stride *= size;
    return right;
  };
  bool all = stands(0);
  for (int axis = PyArray_NDIM(array); axis-- > 1;) all = stands(axis) && all;
  return all;
}

bool overlap(PyArrayObject* a, PyArrayObject* b) {
  const char *a_data = PyArray_BYTES(a), *b_data = PyArray_BYTES(b);
  return a_data < b_data + PyArray_NBYTES(b) && b_data < a_data + PyArray_NBYTES(a);
}

}  // namespace kanec::python
