// One call of a function: its arguments told apart, looked over, and what they are passed on as. Not: the object that
// is called (function.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runtime/python/arrays.hpp"
#include "runtime/python/function.hpp"

namespace kanec::python {

// Borrowed from the caller; null where nothing was given.
struct Arguments {
  std::array<PyObject*, 3> state = {};  // x, y, ydot
  PyObject* t = nullptr;
  PyObject* out = nullptr;
  std::vector<std::pair<int, PyObject*>> values = {};  // parameters and inputs, by number
};

class Call {
 public:
  Call(const Callable& callable, const Arguments& arguments);

  // A new reference. Throws Refused, kanec's errors and Python's.
  PyObject* result();

 private:
  std::string where(const char* what) const;
  npy_intp width(std::size_t i) const;
  bool reads(std::size_t i) const;
  bool reads_float() const;
  const std::string& value_name(int number) const;

  PyObject* one_state();
  double single(PyObject* object, const char* what) const;
  std::span<const double> one(std::size_t i);
  void set_values(Evaluator& evaluator) const;

  void set_count(PyArrayObject* array, npy_intp count, const std::string& what);
  void find_count();
  template <class Real>
  PyObject* many_states();
  Order order(int type) const;
  template <class Real>
  py::object repeated(std::span<const Real> state, Order order) const;
  template <class Real>
  std::span<const Real> many(std::size_t i, Order order);
  template <class Real>
  std::span<const Real> times();
  Values values();

  py::object result_array(const std::vector<npy_intp>& shape, int type, Order order);
  void check_out(const std::vector<npy_intp>& shape, int type) const;

  const Callable& callable_;
  const Arguments& arguments_;
  std::array<py::object, 3> state_ = {};  // as arrays
  std::vector<py::object> kept_ = {};     // what spans point into
  npy_intp count_ = -1;                   // of states; -1: one, in rows
  PyObject* counted_ = nullptr;           // what had the count
};

}  // namespace kanec::python
