// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/errors.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <memory>
#include <new>

#include "kanec/error.hpp"

namespace py = pybind11;

namespace kanec::python {
namespace {

py::object made(const char* name, const std::string& message) {
  return py::module_::import("kanec.errors").attr(name)(message);
}

void set(const py::object& error) { PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr()); }
void set(const char* name, const std::exception& error) { set(made(name, error.what())); }

void set_scene_error(const SceneError& error) {
  const py::object object = made("SceneError", error.what());
  const SceneFault& fault = error.fault();
  object.attr("file") = fault.file;
  object.attr("line") = fault.line;
  object.attr("body") = fault.body;
  object.attr("field") = fault.field;
  object.attr("found") = fault.found;
  object.attr("allowed") = fault.allowed;
  set(object);
}

void set_build_error(const BuildError& error) {
  const py::object object = made("BuildError", error.what());
  object.attr("command") = error.command();
  object.attr("output") = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(error.output().data(), static_cast<Py_ssize_t>(error.output().size()), "replace"));
  set(object);
}

// pybind11 passes on what is thrown here.
void translate(std::exception_ptr thrown) {
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const Refused& error) {
    set("InputError", error);
  } catch (const SceneError& error) {
    set_scene_error(error);
  } catch (const BuildError& error) {
    set_build_error(error);
  } catch (const InputError& error) {
    set("InputError", error);
  } catch (const FileError& error) {
    set("FileError", error);
  } catch (const LoadError& error) {
    set("LoadError", error);
  } catch (const IntegrationError& error) {
    set("IntegrationError", error);
  } catch (const InternalError& error) {
    set("InternalError", error);
  } catch (const Error& error) {
    set("Error", error);
  }
}

}  // namespace

void refuse(const std::string& what, const std::string& found, const std::string& allowed) {
  throw Refused(what + ": found " + found + "; allowed: " + allowed);
}

void register_errors() { py::register_exception_translator(translate); }

void set_python_error() noexcept {
  try {
    try {
      throw;
    } catch (py::error_already_set& error) {
      error.restore();
    } catch (...) {
      translate(std::current_exception());
    }
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  } catch (...) {
    PyErr_SetString(PyExc_RuntimeError, "unknown error");
  }
}

void warn(const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  const py::object note = py::module_::import("kanec.errors").attr("Note");
  for (const std::string& text : notes)
    if (PyErr_WarnEx(note.ptr(), text.c_str(), 1) != 0) throw py::error_already_set();
}

std::function<void()> watch_for_signals() {
  using Clock = std::chrono::steady_clock;
  return [last = std::make_shared<Clock::time_point>(Clock::now())] {
    const Clock::time_point now = Clock::now();
    if (now - *last < std::chrono::milliseconds(50)) return;
    *last = now;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
}

}  // namespace kanec::python
