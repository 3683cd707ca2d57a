// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/table.hpp"

#include <string>

#include "runtime/python/arrays.hpp"
#include "runtime/python/errors.hpp"

namespace kanec::python {
namespace {

constexpr int deepest = 16;
constexpr const char* allowed = "a bool, an int, a float, a str, a list, a tuple, an array or a dict";

Value value_of(py::handle object, const std::string& key, int depth);

Table table_at(py::handle object, const std::string& key, int depth) {
  Table table;
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(object)) {
    const std::string at = key.empty() ? "" : key + ".";
    if (!PyUnicode_Check(name.ptr()))
      refuse(key.empty() ? "the scene" : key, "the key " + std::string(py::repr(name)), "keys that are a str");
    const std::string word = name.cast<std::string>();
    table.emplace_back(word, value_of(value, at + word, depth + 1));
  }
  return table;
}

List list_at(py::handle object, const std::string& key, int depth) {
  List list;
  std::size_t i = 0;
  for (const py::handle value : object)
    list.push_back(value_of(value, key + "[" + std::to_string(i++) + "]", depth + 1));
  return list;
}

Value integer(py::handle object, const std::string& key) {
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
  if (overflow != 0) refuse(key, std::string(py::str(object)), "integers of 64 bits");
  return static_cast<std::int64_t>(value);
}

Value text(py::handle object, const std::string& key) {
  Py_ssize_t size = 0;
  const char* data = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
  if (data != nullptr) return std::string(data, static_cast<std::size_t>(size));
  PyErr_Clear();
  refuse(key, "a str that is no Unicode text", "valid Unicode");
}

Value value_of(py::handle object, const std::string& key, int depth) {
  if (depth > deepest) refuse(key, "more than " + std::to_string(deepest) + " levels", "less");
  if (PyBool_Check(object.ptr())) return object.ptr() == Py_True;
  if (PyLong_Check(object.ptr())) return integer(object, key);
  if (PyFloat_Check(object.ptr())) return PyFloat_AS_DOUBLE(object.ptr());
  if (PyUnicode_Check(object.ptr())) return text(object, key);
  if (PyList_Check(object.ptr()) || PyTuple_Check(object.ptr())) return list_at(object, key, depth);
  if (PyDict_Check(object.ptr())) return table_at(object, key, depth);
  if (PyArray_Check(object.ptr()) || PyArray_CheckScalar(object.ptr())) {
    const py::object plain = object.attr("tolist")();
    if (!PyArray_Check(plain.ptr()) && !PyArray_CheckScalar(plain.ptr())) return value_of(plain, key, depth + 1);
  }
  refuse(key, description(object.ptr()), allowed);
}

}  // namespace

Table table_of(const py::dict& dict) { return table_at(dict, "", 0); }

}  // namespace kanec::python
