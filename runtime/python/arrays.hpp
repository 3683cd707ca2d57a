// Arguments as arrays of numbers: borrowed where they stand as they are needed, else converted. Not: what they mean.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#define NPY_NO_DEPRECATED_API NPY_1_20_API_VERSION
#define PY_ARRAY_UNIQUE_SYMBOL kanec_python_arrays
#ifndef KANEC_IMPORTS_ARRAYS
#define NO_IMPORT_ARRAY
#endif
#include <numpy/arrayobject.h>

#include <string>
#include <vector>

namespace kanec::python {

namespace py = pybind11;

template <class Real>
inline constexpr int type_number = NPY_DOUBLE;
template <>
inline constexpr int type_number<float> = NPY_FLOAT;

inline PyArrayObject* array_of(const py::object& object) { return reinterpret_cast<PyArrayObject*>(object.ptr()); }

// As it is where it is an array, else made of lists and numbers. Throws Refused, with `what` in front.
py::object as_array(PyObject* object, const std::string& what);

// Aligned, C-contiguous, of that type: the same array, or a copy. Throws Refused where it does not hold real numbers.
py::object converted(PyArrayObject* array, int type, const std::string& what);
// The same, entry after entry (below).
py::object converted_by_entries(PyArrayObject* array, int type, const std::string& what);

// A new reference to a new one, not filled.
PyObject* new_array(const std::vector<npy_intp>& shape, int type);

// "an array of float64 (3, 2)", "a str".
std::string description(PyObject* object);
// "(3, 2)"
std::string shape_text(const std::vector<npy_intp>& shape);
std::vector<npy_intp> shape_of(PyArrayObject* array);

// A number; Throws Refused.
double number(PyObject* object, const std::string& what);
// As many numbers, in one row. Throws Refused.
std::vector<double> numbers(PyObject* object, int count, const std::string& what);

// Whether numbers of one state stand one array an entry: a[i * count + j], aligned and in the machine's order of bytes.
bool entry_after_entry(PyArrayObject* array);

bool overlap(PyArrayObject* a, PyArrayObject* b);

}  // namespace kanec::python
